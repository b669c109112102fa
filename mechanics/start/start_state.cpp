// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/start/start_state.hpp"

#include "mechanics/formulation.hpp"
#include "mechanics/model/scales.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

StartState::StartState(const Model& model)
    : model_(model),
      system_(formulation(coordinates).make(model)),
      y_(initial_state(*system_, model)),
      m_(system_->constraints()),
      n_(system_->velocities()),
      size_(extent(model)),
      place_(remoteness(model)),
      scale_(m_) {
    system_->row_scale(scale_.data());
}

VecX StartState::position_residual() {
    VecX phi = VecX::Zero(m_);
    system_->position_residual(0, q(), phi.data());
    return phi;
}

VecX StartState::velocity_residual() {
    VecX rate(m_);
    system_->velocity_residual(0, q(), v(), rate.data());
    return rate;
}

VecX StartState::position_terms() {
    VecX terms = VecX::Zero(m_);
    system_->position_scale(q(), terms.data());
    return terms;
}

MatX StartState::jacobian() {
    MatX C(m_, n_);
    system_->jacobian(0, q(), C.data());
    return C;
}

Real StartState::speed() {
    const Real linear = size_ > 0 ? Real(largest_part(0) / size_) : Real(0);
    return max(linear, largest_part(3));
}

Real StartState::rate() {
    VecX force(n_);
    system_->applied_force(0, q(), v(), force.data());
    Real rate = speed();
    for (const Joint& joint : model_.joints) {
        rate = max(rate, max(Real(abs(joint.amplitude * joint.frequency)), joint.turn.pace()));
        if (size_ > 0) rate = max(rate, Real(joint.shift.pace() / size_));
    }
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
        const Body& body = model_.bodies[i];
        const auto at = 6 * static_cast<Eigen::Index>(i);
        rate = max(rate, Real(sqrt(force.segment<3>(at + 3).norm() / (body.J.trace() / 2))));
        if (size_ > 0) rate = max(rate, Real(sqrt(force.segment<3>(at).norm() / (body.mass * size_))));
    }
    return rate;
}

Real StartState::largest_part(Eigen::Index part) {
    Real largest = 0;
    for (Eigen::Index i = part; i < n_; i += 6) largest = max(largest, Real(velocities().segment<3>(i).norm()));
    return largest;
}

std::vector<Eigen::Index> StartState::length_rows() const {
    std::vector<Eigen::Index> rows;
    each_row([&](std::size_t joint, int k, Eigen::Index row) {
        if (!is_direction_row(model_.joints[joint].type, k)) rows.push_back(row);
    });
    return rows;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
