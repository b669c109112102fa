// SPDX-License-Identifier: BSD-3-Clause
//
// A method that is known to be symplectic and symmetric: Strang splitting into kicks by the potential, and free motion,
// which is split further into rotations about the body axes [hairer2006, Sec. VII.5.3]; between bodies with joints the
// multipliers of RATTLE act with the kicks [hairer2006, Sec. VII.1.4]. Order 2.
#pragma once

#include <algorithm>
#include <vector>

#include "lie/so3.hpp"
#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Steps of systems with velocity coordinates (x', omega) or omega and inertias that are diagonal in body axes.
class SplittingVerlet final : public Integrator {
  public:
    /// `stale`: the second kick repeats the first one, which is not symplectic.
    SplittingVerlet(System& system, bool stale)
        : system_(system),
          stale_(stale),
          per_body_(system.velocities() / system.bodies()),
          q1_(static_cast<std::size_t>(system.group().size())),
          v1_(system.velocities()),
          kick_(v1_),
          force_(v1_),
          correction_(v1_),
          u_(v1_),
          mass_(v1_),
          phi_(VecX::Zero(system.constraints())),
          lambda_(phi_) {
        const int rows = system.mass_block();
        MatX blocks(rows, system.velocities());
        system.mass(nullptr, blocks.data());
        for (int i = 0; i < mass_.size(); ++i) mass_[i] = blocks(i % rows, i);
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        Eigen::Map<VecX> v(system_.v(y), v1_.size());
        push(t, h, y);
        VecX start = v + kick_;
        if (const Status status = drift(t, h, y, start); status != Status::ok) return status;
        if (!stale_) push(t + h, h, q1_.data());
        v1_ += kick_;
        if (phi_.size() > 0) {  // onto C v = 0
            force_ = mass_.cwiseProduct(v1_);
            phi_.setZero();
            const Status status =
                system_.solve_kkt(t + h, q1_.data(), force_.data(), phi_.data(), v1_.data(), lambda_.data());
            if (status != Status::ok) return status;
        }
        std::copy(q1_.begin(), q1_.end(), y);
        v = v1_;
        return Status::ok;
    }

  private:
    /// Half a kick by the forces at q.
    void push(const Real& t, const Real& h, const Real* q) {
        system_.conservative_force(t, q, force_.data());
        kick_ = h / 2 * force_.cwiseQuotient(mass_);
    }

    /// Free motion from (q, v), with multipliers at q such that it ends on the constraints.
    Status drift(const Real& t, const Real& h, const Real* q, VecX& v) {
        for (int i = 0; i < 100; ++i) {
            v1_ = v;
            std::copy_n(q, q1_.size(), q1_.begin());
            move_freely(h);
            if (phi_.size() == 0) return Status::ok;
            system_.position_residual(t + h, q1_.data(), phi_.data());
            if (phi_.norm() <= 16 * epsilon) return Status::ok;
            phi_ /= -h;
            const Status status = system_.solve_kkt(t, q, nullptr, phi_.data(), correction_.data(), lambda_.data());
            if (status != Status::ok) return status;
            v += correction_;
        }
        return Status::newton_failed;
    }

    /// (q1, v1) by h without forces, up to third order.
    void move_freely(const Real& h) {
        u_.setZero();
        for (int i = 0; i < u_.size(); ++i)
            if (i % per_body_ < per_body_ - 3) u_[i] = h * v1_[i];
        system_.group().append_exp(q1_.data(), u_.data(), q1_.data());
        for (const int axis : {0, 1, 2, 1, 0}) turn(axis, axis == 2 ? h : Real(h / 2));
    }

    /// Along the flow of m_k^2 / 2 J_k: every body turns about its axis k, and its momentum the other way.
    void turn(int axis, const Real& h) {
        u_.setZero();
        for (int at = per_body_ - 3; at < u_.size(); at += per_body_) {
            const Vec3 angle = h * v1_[at + axis] * Vec3::Unit(axis), J = mass_.segment<3>(at);
            u_.segment<3>(at) = angle;
            const Vec3 momentum = SO3::exp(-angle) * J.cwiseProduct(v1_.segment<3>(at));
            v1_.segment<3>(at) = momentum.cwiseQuotient(J);
        }
        system_.group().append_exp(q1_.data(), u_.data(), q1_.data());
    }

    System& system_;
    bool stale_;
    int per_body_;
    std::vector<Real> q1_;
    VecX v1_, kick_, force_, correction_, u_, mass_, phi_, lambda_;
};

/// The method as it would be registered; `stale` as above.
inline Method splitting_verlet(bool stale) {
    Factory factory;
    factory.make = [stale](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<SplittingVerlet>(system, stale);
    };
    return {.description = {.name = stale ? "control/stale_splitting" : "control/splitting",
                            .order = stale ? 1 : 2,
                            .cites = {},
                            .summary = "Strang splitting into kicks and rotations about body axes",
                            .force_evaluations = 2,
                            .variable_cost = true,
                            .form = Form::half_explicit,
                            .meets_positions = true,
                            .meets_velocities = true,
                            .preserves = {{Property::symplectic, Domain::constrained},
                                          {Property::symmetric, Domain::constrained},
                                          {Property::momentum, Domain::constrained},
                                          {Property::constraints, Domain::constrained}},
                            .formulations = {"SO3", "S3", "SO3xR3", "S3xR3"}},
            .factory = std::move(factory),
            .file = __FILE__};
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
