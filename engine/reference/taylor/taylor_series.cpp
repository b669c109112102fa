// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/taylor_series.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "engine/reference/taylor/gravity_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::vector<BodySeries> bodies_and_ground(const Model& model, std::size_t size) {
    std::vector<BodySeries> bodies;
    for (const Body& body : model.bodies) bodies.emplace_back(body, size);
    bodies.push_back(BodySeries::fixed(size));
    return bodies;
}

std::size_t checked(int order) {
    if (order < 2) throw std::invalid_argument("a Taylor series of motion needs an order of at least 2");
    return static_cast<std::size_t>(order);
}

}  // namespace

TaylorSeries::TaylorSeries(const Model& model, int order)
    : order_(checked(order)),
      bodies_(bodies_and_ground(model, order_ + 2)),
      joints_(joints_of(model)),
      complement_(model, bodies_, joints_),
      reaction_(bodies_.size()) {
    add_forces(model);
}

std::vector<JointSeries> TaylorSeries::joints_of(const Model& model) {
    std::vector<JointSeries> joints;
    for (const Joint& joint : model.joints) joints.emplace_back(joint, at(joint.first), at(joint.second));
    return joints;
}

void TaylorSeries::add_forces(const Model& model) {
    for (std::size_t i = 0; i < model.bodies.size(); ++i)
        forces_.push_back(std::make_unique<GravitySeries>(model.gravity, model.bodies[i].mass, bodies_[i]));
    const BodyAt body_at = [this](int body) -> BodySeries& { return at(body); };
    model.each([&](const auto& force, std::size_t) { forces_.push_back(series_of(force, body_at)); });
}

Status TaylorSeries::expand(const Real& t, const std::vector<BodyState>& states) {
    if (const Status status = start(t, states); status != Status::ok) return status;
    for (std::size_t k = 0; k < order_; ++k) {
        move_freely(k);
        if (joints_.empty()) continue;
        if (const Status status = constrain(k); status != Status::ok) return status;
    }
    return is_finite() ? Status::ok : Status::non_finite;
}

Status TaylorSeries::start(const Real& t, const std::vector<BodyState>& states) {
    Real sum = 0;
    for (const BodyState& s : states) sum += s.x.sum() + s.R.sum() + s.v.sum() + s.omega.sum();
    if (!isfinite(sum)) return Status::non_finite;
    for (std::size_t i = 0; i < states.size(); ++i) bodies_[i].start(states[i]);
    for (const auto& force : forces_) {
        force->start(t);
        if (force->has_parted(0)) return Status::turn_lost;
    }
    for (JointSeries& joint : joints_) joint.start(t);
    return Status::ok;
}

void TaylorSeries::move_freely(std::size_t k) {
    for (BodySeries& body : bodies_) body.begin(k);
    for (const auto& force : forces_) force->act(k);
    for (JointSeries& joint : joints_) joint.react(k);
    for (std::size_t i = 0; i + 1 < bodies_.size(); ++i) bodies_[i].advance(k);
}

Status TaylorSeries::constrain(std::size_t k) {
    for (JointSeries& joint : joints_) joint.update(k);
    if (k == 0 && !complement_.factor()) return Status::singular_kkt;
    const VecX rho = residual(k);
    if (k == 0 && complement_.contradicts(rho)) return Status::singular_kkt;
    react(complement_.solve(rho), k);
    for (JointSeries& joint : joints_) joint.update(k);
    return Status::ok;
}

VecX TaylorSeries::residual(std::size_t k) const {
    const auto& rows = complement_.rows();
    VecX rho(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t c = 0; c < rows.size(); ++c)
        rho[static_cast<Eigen::Index>(c)] = joints_[rows[c].joint].acceleration(rows[c].row, k) / rows[c].scale;
    return rho;
}

void TaylorSeries::react(const VecX& lambda, std::size_t k) {
    for (JointSeries::Wrench& sum : reaction_) sum = {Vec3::Zero(), Vec3::Zero()};
    for (std::size_t c = 0; c < complement_.rows().size(); ++c) {
        const auto& [index, row, scale] = complement_.rows()[c];
        JointSeries& joint = joints_[index];
        const Real value = lambda[static_cast<Eigen::Index>(c)] / scale;
        joint.set_multiplier(row, k, value);
        const auto add = [&](BodySeries& body, const JointSeries::Wrench& wrench) {
            if (k == 0) body.notice(value * wrench.force, value * wrench.moment);
            JointSeries::Wrench& sum = reaction_[static_cast<std::size_t>(&body - bodies_.data())];
            sum.force -= value * wrench.force, sum.moment -= value * wrench.moment;
        };
        add(joint.first(), joint.on_first(row)), add(joint.second(), joint.on_second(row));
    }
    for (std::size_t i = 0; i + 1 < bodies_.size(); ++i) bodies_[i].correct(reaction_[i].force, reaction_[i].moment, k);
}

bool TaylorSeries::is_finite() const {
    for (const BodySeries& body : bodies_)
        for (const Real& last : {body.v[order_].sum(), body.omega[order_].sum(), body.R[order_].sum()})
            if (!isfinite(last)) return false;
    return true;
}

void TaylorSeries::move_on(const Real& s) {
    for (const auto& force : forces_) force->move_on(s);
}

bool TaylorSeries::has_parted(const Real& s) const {
    return std::any_of(forces_.begin(), forces_.end(), [&](const auto& force) { return force->has_parted(s); });
}

Real TaylorSeries::reach(const Real& limit) const {
    // Squared norms of the coefficients, over all bodies.
    std::vector<std::array<Real, 4>> squares(order_ + 1);
    for (std::size_t k = 0; k <= order_; ++k)
        for (const BodySeries& body : bodies_) {
            squares[k][0] += body.x[k].squaredNorm(), squares[k][1] += body.R[k].squaredNorm();
            squares[k][2] += body.v[k].squaredNorm(), squares[k][3] += body.omega[k].squaredNorm();
        }
    Real linear = 0, angular = 0;
    for (const BodySeries& body : bodies_) {
        const Real a = body.acceleration_size(), alpha = body.turning_size();
        linear += a * a, angular += alpha * alpha;
    }
    const auto small = [&](const Real& s) {
        const Real square = s * s;
        std::array<Real, 4> largest = {linear * square * square, 0, linear * square, angular * square};
        Real power = 1;
        for (std::size_t k = 0; k <= order_; ++k, power *= square)
            for (std::size_t part = 0; part < largest.size(); ++part) {
                const Real term = squares[k][part] * power;
                if (k + 1 >= order_ && term > epsilon * epsilon * largest[part]) return false;
                largest[part] = max(largest[part], term);
            }
        return true;
    };
    Real s = limit;
    while (!small(s)) s = 7 * s / 8;
    return s;
}

std::vector<BodyState> TaylorSeries::states(const Real& s) const {
    std::vector<BodyState> result;
    for (std::size_t i = 0; i + 1 < bodies_.size(); ++i) {
        const BodySeries& body = bodies_[i];
        BodyState state{body.x[order_], body.R[order_], body.v[order_], body.omega[order_]};
        for (std::size_t k = order_; k-- > 0;) {
            state.x = state.x * s + body.x[k], state.R = state.R * s + body.R[k];
            state.v = state.v * s + body.v[k], state.omega = state.omega * s + body.omega[k];
        }
        result.push_back(state);
    }
    return result;
}

std::vector<Real> TaylorSeries::multipliers(const Real& s) const {
    std::vector<Real> lambda;
    for (const bool velocity : {false, true})
        for (const TaylorComplement::Row& row : complement_.rows())
            if (joints_[row.joint].is_velocity(row.row) == velocity)
                lambda.push_back(joints_[row.joint].multiplier(row.row, s));
    return lambda;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
