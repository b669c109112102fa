// SPDX-License-Identifier: BSD-3-Clause
#include "engine/linearised/steady_motion.hpp"

#include <stdexcept>

#include "engine/linearised/derivative.hpp"
#include "lie/so3.hpp"
#include "mechanics/model/scales.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Of differences in time, whose functions are sines of the unit turned by 1 rad.
const Real part_of_turn = Real(1) / 8;

/// What joints leave of the accelerations that forces would cause is below this: nothing moves by itself.
const Real held = Real(1) / 1000000000;

Real or_one(const Real& x) { return x > 0 ? x : Real(1); }

/// exp(t a) y exp(t b) of one body, its place excepted, on which v does not depend.
BodyState moved(const BodyState& state, const Vec3& w, const Vec3& spin, const Real& t) {
    const Mat3 Q = SO3::exp(t * w), S = SO3::exp(t * spin);
    return {state.x, Q * state.R * S, Q * state.v, S.transpose() * state.omega};
}

}  // namespace

SteadyMotion::SteadyMotion(const Model& model, const std::string& formulation, const Model& begun)
    : model_(model),
      system_(make_system(model, formulation)),
      n_(system_->velocities()),
      triples_per_body_(system_->bodies() > 0 ? n_ / 3 / system_->bodies() : 1),
      length_(or_one(extent(model))),
      units_(2 * n_),
      row_units_(system_->position_constraints() + system_->constraints()),
      start_(initial_state(*system_, begun)) {
    set_units(1);
    // An equilibrium has a rate only in its neighbourhood.
    Real rate = rate_of(start_), of_forces = rate_of_forces(start_, begun);
    for (int i = 0; i < n_; ++i) {
        const std::vector<Real> near = state(part_of_turn * VecX::Unit(2 * n_, i));
        rate = max(rate, rate_of(near)), of_forces = max(of_forces, rate_of_forces(near, begun));
    }
    set_units(or_one(rate * rate <= held * of_forces * of_forces ? of_forces : rate));
}

void SteadyMotion::set_units(const Real& rate) {
    rate_ = rate;
    for (int i = 0; i < n_; ++i) {
        const bool is_translation = triples_per_body_ == 2 && i / 3 % 2 == 0;
        units_[i] = is_translation ? length_ : Real(1);
        units_[n_ + i] = rate * units_[i];
    }
    const int positions = system_->position_constraints(), all = system_->constraints();
    if (all == 0) return;
    VecX scale(all);
    system_->row_scale(scale.data());
    row_units_ << scale.head(positions), rate * scale;
}

/// From velocity and acceleration (error_norm.hpp chooses steps by the same).
Real SteadyMotion::rate_of(const std::vector<Real>& y) {
    const VecX z = field(y);  // with the rate 1 as unit
    Real square = 0;
    for (int i = 0; i < n_; i += 3) {
        square = max(square, Real(z.segment<3>(i).squaredNorm()));
        square = max(square, Real(z.segment<3>(n_ + i).norm()));
    }
    return sqrt(square);
}

/// sqrt(force / (mass length)) and sqrt(torque / moment of inertia): the largest that gravity or one force causes, as
/// forces may balance each other too.
Real SteadyMotion::rate_of_forces(const std::vector<Real>& y, const Model& begun) const {
    std::vector<BodyState> states(model_.bodies.size());
    system_->read(y.data(), states.data());
    const auto motion = [&](int body) -> Motion {
        if (body == ground) return {};
        const BodyState& s = states[static_cast<std::size_t>(body)];
        return {s.x, s.R, s.R.transpose() * s.v, s.omega};
    };
    const auto angle = [&](std::size_t i, const Turn& turn) {
        return Real(turn.principal + 2 * pi() * Real(begun.torsion_springs[i].turns));
    };
    Real square = states.empty() ? Real(0) : Real(model_.gravity.at(0).norm() / length_);
    for_each_wrench(model_, 0, motion, angle, [&](int i, const Wrench& wrench) {
        const Body& body = model_.bodies[static_cast<std::size_t>(i)];
        square = max(square, Real(wrench.force.norm() / (body.mass * length_)));
        if (!body.point) square = max(square, Real(wrench.torque.norm() / (body.J.trace() / 2)));
    });
    return sqrt(square);
}

std::vector<Real> SteadyMotion::state(const VecX& z) const {
    const VecX u = z.cwiseProduct(units_);
    std::vector<Real> y(start_.size());
    system_->state_group().append_exp(start_.data(), u.data(), y.data());
    return y;
}

VecX SteadyMotion::field(const std::vector<Real>& y) {
    VecX z(2 * n_);
    const Status status = system_->vector_field(0, y.data(), z.data());
    if (status != Status::ok) throw std::domain_error(std::string("the equations of motion: ") + name(status));
    return in_units(z);
}

VecX SteadyMotion::generated(const std::vector<Real>& y, const Generator& c) const {
    std::vector<BodyState> states(model_.bodies.size()), some(states.size());
    system_->read(y.data(), states.data());
    std::vector<Real> written = y;
    // A velocity by which the bodies would move as the generator moves them is its part in the algebra of G.
    for (std::size_t i = 0; i < states.size(); ++i) {
        const BodyState& s = states[i];
        some[i] = {s.x, s.R, c.u + c.w.cross(s.x), s.R.transpose() * c.w + c.spins[i]};
    }
    system_->write(some.data(), written.data());
    VecX z(2 * n_);
    z.head(n_) = Eigen::Map<const VecX>(system_->v(written.data()), n_);
    const auto velocity = [&](const Real& t) {
        for (std::size_t i = 0; i < states.size(); ++i) some[i] = moved(states[i], c.w, c.spins[i], t);
        system_->write(some.data(), written.data());
        return VecX(Eigen::Map<const VecX>(system_->v(written.data()), n_));
    };
    Real turns = c.w.norm();
    for (const Vec3& spin : c.spins) turns = max(turns, Real(spin.norm()));
    z.tail(n_) = derivative_at_zero(velocity, Real(part_of_turn / or_one(turns)));
    return in_units(z);
}

VecX SteadyMotion::residuals(const std::vector<Real>& y) const {
    const int positions = system_->position_constraints(), all = system_->constraints();
    VecX residual(positions + all);
    if (all == 0) return residual;
    VecX phi = VecX::Zero(all);
    system_->position_residual(0, system_->q(y.data()), phi.data());
    residual.head(positions) = phi.head(positions);
    system_->velocity_residual(0, system_->q(y.data()), system_->v(y.data()), residual.data() + positions);
    return residual.cwiseQuotient(row_units_);
}

bool SteadyMotion::is_idle(int i) const {
    const int triple = i % n_ / 3;
    return triples_per_body_ == 2 && triple % 2 == 1 && model_.bodies[static_cast<std::size_t>(triple / 2)].point;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
