// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/rows/turn_rows.hpp"

#include "engine/reference/taylor/rows/prescribed_series.hpp"
#include "engine/reference/taylor/rows/turned_row.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class PrescribedTurnRow final : public TurnedRow {
  public:
    PrescribedTurnRow(const Joint& joint, const JointEnds& ends)
        : TurnedRow(joint, joint.axes_first.col(0), joint.axes_first.col(1), ends), law_(joint.turn) {}
    void start(const Real& t) override { expand(law_, t, f_); }

  private:
    Prescribed law_;
};

/// f = radians e . d for an axis e of one of the bodies. If it turns with the first, so does the gradient: there is a
/// moment e x d.
class AdvancedTurnRow final : public TurnedRow {
  public:
    enum class Carrier { first, second };
    AdvancedTurnRow(const Joint& joint, const Vec3& a1, const Vec3& a2, const Real& radians, Carrier carrier,
                    const JointEnds& ends)
        : TurnedRow(joint, a1, a2, ends),
          radians_(radians),
          turns_with_first_(carrier == Carrier::first),
          axis_(turns_with_first_ ? ends.first : ends.second,
                (turns_with_first_ ? joint.axes_first : joint.axes_second).col(2)),
          push_(scalars(ends)),
          n_(ends.d) {}
    const Vectors* n() const override { return &n_; }
    void follow(const JointEnds& ends, std::size_t i) override {
        axis_.update(i);
        f_[i] = radians_ * dot(axis_.series(), ends.d, i);
        TurnedRow::follow(ends, i);
    }
    void direct(const JointEnds& ends, std::size_t k) override {
        TurnedRow::direct(ends, k);
        push_[k] = radians_ * slope(k);
        n_[k] = product(push_, axis_.series(), k);
        if (turns_with_first_) t_[k] += cross(n_, ends.d, k);
    }

  private:
    Real radians_;  // for each metre of e . d
    bool turns_with_first_;
    Attached axis_;
    Scalars push_;
    Vectors n_;
};

}  // namespace

std::unique_ptr<DirectionRowSeries> prescribed_turn_row(const Joint& joint, const JointEnds& ends) {
    return std::make_unique<PrescribedTurnRow>(joint, ends);
}

std::unique_ptr<DirectionRowSeries> helix_row(const Joint& joint, const JointEnds& ends) {
    const Mat3& a = joint.axes_first;
    return std::make_unique<AdvancedTurnRow>(joint, a.col(0), a.col(1), -2 * pi() / joint.lead,
                                             AdvancedTurnRow::Carrier::second, ends);
}

std::unique_ptr<DirectionRowSeries> rack_row(const Joint& joint, const JointEnds& ends) {
    const Mat3& a = joint.axes_first;
    return std::make_unique<AdvancedTurnRow>(joint, a.col(2), -a.col(1), 2 * pi() / joint.lead,
                                             AdvancedTurnRow::Carrier::first, ends);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
