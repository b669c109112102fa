// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/row_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Scalars scalars(const JointEnds& ends) { return Scalars(ends.d.size(), Real(0)); }
Real twice(std::size_t k) { return real(k + 1) * real(k + 2); }

/// d = 0.
class CoincidenceRow final : public PointRowSeries {
  public:
    explicit CoincidenceRow(const JointEnds& ends) : PointRowSeries(ends) {
        for (int k = 0; k < 3; ++k) {
            n_.push_back(vectors(ends.first));
            n_.back()[0] = Vec3::Unit(k);
        }
    }
    void follow(const JointEnds& ends, std::size_t i) override { lever_[i] = ends.arm_second[i]; }
    Real acceleration(const JointEnds& ends, int row, std::size_t k) const override {
        return twice(k) * n(row)[0].dot(ends.d[k + 2]);
    }
};

/// b . d = 0 for axes b of the second body. The force acts at the point of the first.
class AlongRow final : public PointRowSeries {
  public:
    AlongRow(const Joint& joint, const JointEnds& ends) : PointRowSeries(ends) {
        for (const JointRow& row : joint.type->rows)
            if (row.primitive == Primitive::along) {
                axes_.emplace_back(joint.axes_second.col(row.k));
                n_.push_back(vectors(ends.first));
            }
    }
    bool turns() const override { return true; }
    void follow(const JointEnds& ends, std::size_t i) override {
        lever_[i] = ends.arm_second[i];
        lever_[i] += ends.d[i];
        for (std::size_t r = 0; r < axes_.size(); ++r) n_[r][i] = ends.second.R[i] * axes_[r];
    }
    Real acceleration(const JointEnds& ends, int row, std::size_t k) const override {
        return twice(k) * dot(n(row), ends.d, k + 2);
    }

  private:
    Vectors axes_;
};

/// |d| = L(t), n = d / |d|.
class DistanceRow final : public PointRowSeries {
  public:
    DistanceRow(const Joint& joint, const JointEnds& ends)
        : PointRowSeries(ends), joint_(joint), square_(scalars(ends)), length_(square_), law_(square_) {
        n_.push_back(vectors(ends.first));
    }
    bool turns() const override { return true; }
    void start(const Real& t) override {
        modulate(joint_.amplitude, joint_.frequency, t, law_);
        for (Real& coefficient : law_) coefficient *= joint_.length;
    }
    void follow(const JointEnds& ends, std::size_t i) override {
        lever_[i] = ends.arm_second[i];
        square_[i] = dot(ends.d, ends.d, i);
        length_[i] = square_root(square_, length_, i);
    }
    void direct(const JointEnds& ends, std::size_t k) override { n_[0][k] = quotient(ends.d, length_, n_[0], k); }
    Real acceleration(const JointEnds&, int, std::size_t k) const override {
        return twice(k) * (length_[k + 2] - law_[k + 2]);
    }

  private:
    Joint joint_;
    Scalars square_, length_, law_;  // |d|^2, |d|, L
};

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

JointEnds::JointEnds(const Joint& joint, BodySeries& first_body, BodySeries& second_body)
    : first(first_body),
      second(second_body),
      arm_first(first, joint.r_first),
      arm_second(second, joint.r_second),
      d(vectors(first)) {}

void JointEnds::follow(std::size_t i) {
    arm_first.update(i), arm_second.update(i);
    d[i] = first.x[i] + arm_first[i] - second.x[i] - arm_second[i];
}

std::unique_ptr<PointRowSeries> point_rows(const Joint& joint, const JointEnds& ends) {
    if (joint.type->has(Primitive::coincidence)) return std::make_unique<CoincidenceRow>(ends);
    if (joint.type->has(Primitive::along)) return std::make_unique<AlongRow>(joint, ends);
    if (joint.type->has(Primitive::distance)) return std::make_unique<DistanceRow>(joint, ends);
    if (joint.type->has(Primitive::contact)) return std::make_unique<ContactRow>(joint, ends);
    return nullptr;
}

TurnRow::TurnRow(const Joint& joint, const JointRow& row, const JointEnds& ends)
    : a_(ends.first, joint.axes_first.col(row.i)), b_(ends.second, joint.axes_second.col(row.k)), t_(ends.d) {}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
