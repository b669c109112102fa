// SPDX-License-Identifier: BSD-3-Clause
//
// mu and nu by a Newton iteration with the derivative 2 C M^{-1} C^T of its residuals at h = 0: each iteration takes a
// step and contracts by O(h). D(q+) is taken at the iterate before, which is the same once that stands still.
#include "methods/symmetric_projection/symmetric_projection.hpp"

#include <limits>

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/implicit/motion_scale.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr int most_passes = KREISEL_QUAD ? 100 : 50;
/// Iterations that no longer halve what is left have converged, if that is at most so much round-off.
const Real stagnation = 1000;

class SymmetricProjection final : public Integrator {
  public:
    SymmetricProjection(System& system, std::unique_ptr<Integrator> base)
        : system_(system),
          base_(std::move(base)),
          scale_(system),
          n_(system.velocities()),
          m_(system.constraints()),
          mu_(VecX::Zero(m_)),
          nu_(mu_),
          rows_(mu_),
          change_(mu_),
          terms_(VecX::Zero(system.position_constraints())),
          lengths_(VecX::Ones(m_)),
          moved_(VecX::Zero(n_)),
          force_(moved_),
          correction_(moved_),
          state_(static_cast<std::size_t>(system.state_group().size())),
          end_(state_) {
        system_.row_scale(lengths_.data());
    }

    Status start(const Real& t, const Real* y) override {
        scale_.forget();
        return base_->start(t, y);
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (m_ == 0 || h == 0) return finish(base_->step(t, h, y));
        scale_.weigh(y);
        motion_ = scale_.of_motion(t, h, y);
        if (!isfinite(motion_)) return Status::non_finite;
        const Status status = iterate(t, h, y);
        if (status == Status::ok) std::copy(end_.begin(), end_.end(), y);
        return finish(status);
    }

  private:
    Status finish(Status status) {
        work_ = base_->work();
        return status;
    }

    Status iterate(const Real& t, const Real& h, const Real* y) {
        mu_.setZero(), nu_.setZero();
        Real previous = std::numeric_limits<Real>::max();
        for (int i = 0; i < most_passes; ++i) {
            if (const Status status = pass_through(t, h, y, i == 0); status != Status::ok) return status;
            if (const Status status = correct(t + h); status != Status::ok) return status;
            if (!isfinite(size_)) return Status::non_finite;
            if (size_ <= 1 || (2 * size_ > previous && size_ <= stagnation)) return Status::ok;
            previous = size_;
        }
        return Status::newton_failed;
    }

    /// end_ from y by mu_ and nu_. At the first one, where both are zero, there is no iterate before.
    Status pass_through(const Real& t, const Real& h, const Real* y, bool first) {
        std::copy_n(y, state_.size(), state_.data());
        move(t, y, state_.data());
        if (const Status status = base_->start(t, state_.data()); status != Status::ok) return status;
        if (const Status status = base_->step(t, h, state_.data()); status != Status::ok) return status;
        if (first) end_ = state_;
        move(t + h, end_.data(), state_.data());
        end_ = state_;
        return Status::ok;
    }

    /// y <- (q exp(D mu), v + D nu), with D at the configuration `at`.
    void move(const Real& t, const Real* at, Real* y) {
        displacement(t, at, mu_);
        system_.group().append_exp(y, moved_.data(), y);
        displacement(t, at, nu_);
        Eigen::Map<VecX>(system_.v(y), n_) += moved_;
    }

    /// moved_ = D(q) multipliers.
    void displacement(const Real& t, const Real* q, const VecX& multipliers) {
        system_.apply_jacobian_transpose(t, q, multipliers.data(), force_.data());
        system_.solve_mass(q, force_.data(), moved_.data());
    }

    /// Corrects mu_ and nu_ by the residuals at end_; size_ is the larger of Phi and of what moves the velocities, in
    /// units of their round-off.
    Status correct(const Real& t) {
        const Real* q = end_.data();
        if (const Status status = system_.prepare_kkt(t, q); status != Status::ok) return status;
        rows_.setZero();
        system_.position_residual(t, q, rows_.data());
        system_.position_scale(q, terms_.data());
        size_ = rows_.cwiseAbs().cwiseQuotient(terms_.cwiseMax(lengths_)).maxCoeff() / (4 * epsilon);
        if (const Status status = add_correction(t, q, mu_); status != Status::ok) return status;
        system_.velocity_residual(t, q, system_.v(q), rows_.data());
        if (const Status status = add_correction(t, q, nu_); status != Status::ok) return status;
        size_ = max(size_, Real(scale_.of_velocity(correction_.data()) / (epsilon * motion_)));
        return Status::ok;
    }

    /// Half of what would move end_ onto the rows, since the other half is moved before the step.
    Status add_correction(const Real& t, const Real* q, VecX& multipliers) {
        rows_ = -rows_;
        const Status status = system_.solve_prepared(t, q, nullptr, rows_.data(), correction_.data(), change_.data());
        multipliers -= change_ / 2;
        return status;
    }

    System& system_;
    std::unique_ptr<Integrator> base_;
    MotionScale scale_;
    Eigen::Index n_, m_;
    VecX mu_, nu_, rows_, change_, terms_, lengths_;
    VecX moved_, force_, correction_;
    std::vector<Real> state_, end_;
    Real motion_ = 0, size_ = 0;
};

std::string why_not_symmetric(const System& system) {
    return system.position_constraints() < system.constraints() ? "rows without a position level (rolling)" : "";
}

}  // namespace

Factory symmetric_projection(const std::string& base) {
    Factory factory;
    factory.make = [base](System& system, const OptionValues&, const MethodDescription&) {
        const Method& method = kreisel::method(base);
        auto step = method.factory.make(system, with_defaults({}, method.factory.options), method.description);
        return std::make_unique<SymmetricProjection>(system, std::move(step));
    };
    factory.declines = why_not_symmetric;
    return factory;
}

MethodDescription symmetrically_projected(const std::string& scheme, const std::string& base, Order order,
                                          const std::string& source) {
    return {.name = "symmetric_projection/" + scheme,
            .order = order,
            .cites = {"hairer2000", source},
            .summary = base + " between equal and opposite projections, which keep its symmetry",
            .variable_cost = true,
            .form = Form::implicit,
            .meets_positions = true,
            .meets_velocities = true,
            .preserves = {{Property::symmetric, Domain::constrained}, {Property::constraints, Domain::constrained}}};
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
