// SPDX-License-Identifier: BSD-3-Clause
#include "engine/metrics/observation.hpp"

#include <limits>

namespace kreisel {
inline namespace KREISEL_PRECISION {

Observation::Observation(System& system)
    : system_(system),
      bodies_(static_cast<std::size_t>(system.bodies())),
      springs_(static_cast<std::size_t>(system.torsion_springs())),
      angles_(springs_.size()),
      kinds_(system.constraint_rows()),
      xi_(system.constraints()),
      bias_(system.constraints()),
      dv_(system.velocities()) {
    for (Rows& rows : rows_) rows.values.resize(system.constraints());
}

void Observation::move_to(const Real& t, const Real* y) {
    t_ = t, y_ = y;
    motion_known_ = false;
    for (Rows& rows : rows_) rows.known = false;
}

void Observation::read_motion() {
    if (motion_known_) return;
    system_.read(y_, bodies_.data());
    system_.read_angles(y_, springs_.data());
    for (std::size_t i = 0; i < angles_.size(); ++i) angles_[i] = springs_[i].theta;
    motion_known_ = true;
}

const std::vector<BodyState>& Observation::bodies() {
    read_motion();
    return bodies_;
}

const std::vector<SpringAngle>& Observation::springs() {
    read_motion();
    return springs_;
}

MotionState Observation::motion() {
    read_motion();
    return {bodies_, angles_};
}

const VecX& Observation::rows(RowLevel level) {
    Rows& rows = rows_[static_cast<std::size_t>(level)];
    if (!rows.known) measure(level, rows.values);
    rows.known = true;
    return rows.values;
}

void Observation::measure(RowLevel level, VecX& rows) {
    const Real* v = y_ + system_.group().size();
    switch (level) {
        case RowLevel::position:
            rows.setZero();  // rows without a position level
            system_.position_residual(t_, y_, rows.data());
            break;
        case RowLevel::velocity:
            system_.velocity_residual(t_, y_, v, rows.data());
            break;
        case RowLevel::acceleration:
            measure_accelerations(rows);
            break;
    }
}

void Observation::measure_accelerations(VecX& rows) {
    const Real* v = y_ + system_.group().size();
    ++evaluations_;
    if (system_.accelerations(t_, y_, v, dv_.data(), nullptr) != Status::ok) {
        rows.setConstant(std::numeric_limits<Real>::quiet_NaN());
        return;
    }
    system_.velocity_residual(t_, y_, dv_.data(), rows.data());  // C v' + b
    system_.velocity_bias(t_, y_, bias_.data());
    system_.acceleration_bias(t_, y_, v, xi_.data());
    rows -= bias_ + xi_;
}

Real Observation::norm(RowLevel level, bool direction) {
    const VecX& all = rows(level);
    Real sum = 0;
    for (std::size_t i = 0; i < kinds_.size(); ++i)
        if (const Real& row = all[static_cast<Eigen::Index>(i)]; kinds_[i].direction == direction) sum += row * row;
    return sqrt(sum);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
