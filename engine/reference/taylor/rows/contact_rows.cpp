// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/rows/contact_rows.hpp"

#include "engine/reference/taylor/rows/scalars.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// A disk of axis b on the plane of normal n: s = n - (n . b) b leads away from the contact, which is L s/|s| below the
/// centre. One row on its height, two on the velocity of the point in contact.
class ContactRow final : public PointRowSeries {
  public:
    ContactRow(const Joint& joint, const JointEnds& ends)
        : PointRowSeries(ends),
          radius_(joint.length),
          axis_(ends.second, joint.axes_second.col(2)),
          cosine_(scalars(ends)),
          square_(cosine_),
          length_(cosine_),
          s_(ends.d),
          unit_(s_),
          omega_(s_) {
        for (const int k : {2, 0, 1}) {
            n_.push_back(vectors(ends.first));
            n_.back()[0] = joint.axes_first.col(k);
        }
    }
    bool is_velocity(int row) const override { return row > 0; }
    /// Here s has the opposite sign; omega stands one coefficient below R.
    void follow(const JointEnds& ends, std::size_t i) override {
        lever_[i] = ends.arm_second[i];
        const Vec3& normal = n_[0][0];
        axis_.update(i);
        cosine_[i] = normal.dot(axis_[i]);
        s_[i] = product(cosine_, axis_.series(), i);
        if (i == 0) s_[i] -= normal;
        square_[i] = dot(s_, s_, i);
        length_[i] = square_root(square_, length_, i);
        unit_[i] = quotient(s_, length_, unit_, i);
        lever_[i] += radius_ * unit_[i];
        if (i > 0) omega_[i - 1] = product(ends.second.R, ends.second.omega, i - 1);
    }
    Real acceleration(const JointEnds& ends, int row, std::size_t k) const override {
        const BodySeries& disk = ends.second;
        if (!is_velocity(row)) return -twice(k) * n(row)[0].dot(disk.x[k + 2] + lever_[k + 2]);
        return -real(k + 1) * n(row)[0].dot(rate(disk.x, k + 1) + cross(omega_, lever_, k + 1));
    }

  private:
    Real radius_;
    Attached axis_;
    Scalars cosine_, square_, length_;  // n . b, |s|^2, |s|
    Vectors s_, unit_, omega_;          // -s, -s/|s|, and omega in space axes
};

}  // namespace

std::unique_ptr<PointRowSeries> contact_rows(const Joint& joint, const JointEnds& ends) {
    return std::make_unique<ContactRow>(joint, ends);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
