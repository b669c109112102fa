// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/engine/taylor_series.hpp"

#include <array>
#include <stdexcept>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Eigen::Index row(std::size_t joint) { return 3 * static_cast<Eigen::Index>(joint); }

Real real(std::size_t k) { return static_cast<int>(k); }

/// d^k/dt^k (1 + A sin(W t)) / k!.
Real modulation(const Real& amplitude, const Real& frequency, const Real& t, std::size_t k) {
    Real factor = amplitude;
    for (std::size_t i = 1; i <= k; ++i) factor *= frequency / real(i);
    const Real phase = frequency * t;
    const std::array<Real, 4> derivatives = {sin(phase), cos(phase), -sin(phase), -cos(phase)};
    return (k == 0 ? 1 : 0) + factor * derivatives[k % 4];
}

}  // namespace

TaylorSeries::TaylorSeries(const Model& model, int order) : model_(model), order_(static_cast<std::size_t>(order)) {
    if (order < 2) throw std::invalid_argument("a Taylor series of motion needs an order of at least 2");
    const std::vector<Vec3> zeros(order_ + 1, Vec3::Zero());
    for (const Body& body : model_.bodies)
        bodies_.push_back({zeros, zeros, zeros, zeros, std::vector<Mat3>(order_ + 1), body.J.inverse(), Vec3::Zero(), Vec3::Zero()});
    lambda_.assign(model_.joints.size(), zeros);
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
        const Joint& joint = model_.joints[j];
        const auto add = [&](int body, const Vec3& r, int sign) {
            if (body != ground)
                ends_.push_back({static_cast<std::size_t>(body), j, Real(sign), r, zeros, zeros, Vec3::Zero()});
        };
        add(joint.first, joint.r_first, 1), add(joint.second, joint.r_second, -1);
    }
    schur_.resize(row(lambda_.size()), row(lambda_.size()));
    rhs_.resize(schur_.rows()), solution_.resize(schur_.rows());
}

/// S = sum over pairs of ends on one body of s s' (I/m - R hat(r) J^{-1} hat(r') R^T).
bool TaylorSeries::factor() {
    schur_.setZero();
    for (const End& a : ends_)
        for (const End& b : ends_) {
            if (a.body != b.body) continue;
            const BodySeries& body = bodies_[a.body];
            const Mat3 turning = body.R[0] * hat(a.r) * body.inverse_inertia * hat(b.r) * body.R[0].transpose();
            const Mat3 moving = Mat3::Identity() / model_.bodies[a.body].mass;
            schur_.block<3, 3>(row(a.joint), row(b.joint)) += a.sign * b.sign * (moving - turning);
        }
    if (lambda_.empty()) return true;
    factors_.compute(schur_);
    return factors_.isInvertible();
}

/// d^k/dt^k g(t) / k!.
Vec3 TaylorSeries::gravity(const Real& t, std::size_t k) const {
    return model_.gravity.g * modulation(model_.gravity.amplitude, model_.gravity.frequency, t, k);
}

/// Coefficients k of a load: the product of its modulation with R for what has to change axes.
void TaylorSeries::add_load(const Load& load, const Real& t, std::size_t k) {
    BodySeries& body = bodies_[static_cast<std::size_t>(load.body)];
    Mat3 R = Mat3::Zero();
    for (std::size_t j = 0; j <= k; ++j) R += body.R[j] * modulation(load.amplitude, load.frequency, t, k - j);
    const Real factor = modulation(load.amplitude, load.frequency, t, k);
    const bool turns = load.axes == Load::Axes::body;
    const Vec3 force = turns ? Vec3(R * load.force) : Vec3(factor * load.force);
    body.free += force / model_.bodies[static_cast<std::size_t>(load.body)].mass;
    body.torque += turns ? Vec3(factor * load.torque) : Vec3(R.transpose() * load.torque);
}

/// -(omega x J omega)_k.
void TaylorSeries::prepare_body(BodySeries& body, std::size_t k) const {
    body.torque.setZero();
    for (std::size_t j = 0; j <= k; ++j) body.torque -= body.omega[j].cross(body.momentum[k - j]);
}

/// All of (R p)_k and (R^T lambda)_k that lower coefficients decide.
void TaylorSeries::prepare_end(End& end, std::size_t k) {
    BodySeries& body = bodies_[end.body];
    const Vectors& lambda = lambda_[end.joint];
    end.velocity[k] = body.omega[k].cross(end.r);
    end.p[k].setZero();
    for (std::size_t j = 0; j <= k; ++j) end.p[k] += body.omega[j].cross(end.velocity[k - j]);
    end.known = body.R[0] * end.p[k];
    Vec3 force = Vec3::Zero();
    for (std::size_t j = 1; j <= k; ++j) {
        end.known += body.R[j] * end.p[k - j];
        force += body.R[j].transpose() * lambda[k - j];
    }
    body.torque -= end.sign * end.r.cross(force);
}

/// Coefficients k of lambda, v' and omega'.
void TaylorSeries::solve(std::size_t k) {
    rhs_.setZero();
    for (const End& end : ends_) {
        const BodySeries& body = bodies_[end.body];
        const Vec3 alpha = body.inverse_inertia * body.torque;
        rhs_.segment<3>(row(end.joint)) += end.sign * (body.free + body.R[0] * alpha.cross(end.r) + end.known);
    }
    if (!lambda_.empty()) solution_ = factors_.solve(rhs_);
    for (BodySeries& body : bodies_) body.v[k + 1] = body.free;
    for (const End& end : ends_) {
        BodySeries& body = bodies_[end.body];
        const Vec3 lambda = solution_.segment<3>(row(end.joint));
        lambda_[end.joint][k] = lambda;
        body.v[k + 1] -= end.sign / model_.bodies[end.body].mass * lambda;
        body.torque -= end.sign * end.r.cross(body.R[0].transpose() * lambda);
    }
    for (BodySeries& body : bodies_) body.omega[k + 1] = body.inverse_inertia * body.torque;
    for (End& end : ends_) end.p[k] += bodies_[end.body].omega[k + 1].cross(end.r);
}

/// Coefficients k + 1 of the state from coefficients k of its derivative.
void TaylorSeries::raise(BodySeries& body, std::size_t k) const {
    const Real next = real(k + 1);
    body.v[k + 1] /= next, body.omega[k + 1] /= next;
    body.x[k + 1] = body.v[k] / next;
    body.R[k + 1].setZero();
    for (std::size_t j = 0; j <= k; ++j)
        for (int i = 0; i < 3; ++i) {
            const Vec3 r = body.R[j].row(i);
            body.R[k + 1].row(i) += r.cross(body.omega[k - j]).transpose();
        }
    body.R[k + 1] /= next;
}

Status TaylorSeries::expand(const Real& t, const std::vector<BodyState>& states) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        BodySeries& body = bodies_[i];
        body.x[0] = states[i].x, body.R[0] = states[i].R, body.v[0] = states[i].v, body.omega[0] = states[i].omega;
    }
    Real sum = 0;
    for (const BodySeries& body : bodies_)
        sum += body.x[0].sum() + body.R[0].sum() + body.v[0].sum() + body.omega[0].sum();
    if (!isfinite(sum)) return Status::non_finite;
    if (!factor()) return Status::singular_kkt;
    for (std::size_t k = 0; k < order_; ++k) {
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            bodies_[i].momentum[k] = model_.bodies[i].J * bodies_[i].omega[k];
            prepare_body(bodies_[i], k);
            bodies_[i].free = gravity(t, k);
        }
        for (const Load& load : model_.loads) add_load(load, t, k);
        for (End& end : ends_) prepare_end(end, k);
        solve(k);
        for (BodySeries& body : bodies_) raise(body, k);
    }
    for (const BodySeries& body : bodies_)
        for (const Real& last : {body.v[order_].sum(), body.omega[order_].sum(), body.R[order_].sum()})
            if (!isfinite(last)) return Status::non_finite;
    return Status::ok;
}

Real TaylorSeries::reach(const Real& limit) const {
    // Squared norms of the coefficients, over all bodies.
    std::vector<std::array<Real, 4>> squares(order_ + 1);
    for (std::size_t k = 0; k <= order_; ++k)
        for (const BodySeries& body : bodies_) {
            squares[k][0] += body.x[k].squaredNorm(), squares[k][1] += body.R[k].squaredNorm();
            squares[k][2] += body.v[k].squaredNorm(), squares[k][3] += body.omega[k].squaredNorm();
        }
    const auto small = [&](const Real& s) {
        std::array<Real, 4> largest{};
        Real power = 1;
        for (std::size_t k = 0; k <= order_; ++k, power *= s * s)
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
    for (const BodySeries& body : bodies_) {
        BodyState state{body.x[order_], body.R[order_], body.v[order_], body.omega[order_]};
        for (std::size_t k = order_; k-- > 0;) {
            state.x = state.x * s + body.x[k], state.R = state.R * s + body.R[k];
            state.v = state.v * s + body.v[k], state.omega = state.omega * s + body.omega[k];
        }
        result.push_back(state);
    }
    return result;
}

std::vector<Real> TaylorSeries::multipliers() const {
    std::vector<Real> rows;
    for (const Vectors& lambda : lambda_) rows.insert(rows.end(), {lambda[0][0], lambda[0][1], lambda[0][2]});
    return rows;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
