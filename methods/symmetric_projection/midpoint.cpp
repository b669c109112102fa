// SPDX-License-Identifier: BSD-3-Clause
//
// The implicit midpoint rule on TG with symmetric projection [hairer2000], [hairer2006, V.4.1]: a projection before the
// step and one after it by the same multipliers, which restores the symmetry that a projection after the step destroys.
// With G = M^{-1} C^T, f = v' of the index-1 form,
//   q~ = q exp(h G(q) mu),   v~ = v + G(q) nu,
//   V = (v~ + v~+)/2,   q~+ = q~ exp(h V),   v~+ = v~ + h f(t + h/2, q~ exp(h V/2), V),
//   q+ = q~+ exp(h G(q+) mu),   v+ = v~+ + G(q+) nu,
// with mu and nu such that Phi(t+, q+) = 0 and C(t+, q+) v+ + b(t+, q+) = 0. Exchanging the ends, h by -h and nu by -nu
// gives the same equations: the method is symmetric. The cited papers have C^T for G; mu and nu are O(h^2) and O(h^3),
// so that the order is that of the midpoint rule. Without joints it is rkmk/implicit_midpoint.
#include <algorithm>

#include "methods/contract/integrator.hpp"
#include "methods/implicit/newton.hpp"
#include "methods/implicit/position_weights.hpp"
#include "methods/implicit/predictor.hpp"
#include "methods/symmetric_projection/projected_midpoint.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class SymmetricMidpoint final : public Integrator, private Equations {
  public:
    explicit SymmetricMidpoint(System& system)
        : system_(system),
          n_(system.velocities()),
          m_(system.constraints()),
          scale_(system),
          rows_(system, scale_),
          equations_(system, scale_),
          newton_(equations_.unknowns()),
          past_(equations_.unknowns()),
          x_(VecX::Zero(equations_.unknowns())),
          r_(x_),
          turned_(x_),
          weights_(VecX::Ones(x_.size())) {}

    Status start(const Real&, const Real*) override {
        h_ = 0;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h == 0) return system_.evaluate(t, y, system_.v(y), x_.data());
        q_ = y;
        if (h != h_)
            if (const Status status = begin(t, h, y); status != Status::ok) return status;
        h_ = 0;  // until this step has succeeded
        weigh(t, h, y);
        equations_.begin(t, h, y, system_.v(y));
        Status status = iterate();
        work_.newton_iterations = newton_.iterations();
        if (status == Status::newton_failed) status = find_cause();
        if (status == Status::ok) status = settle();
        if (status != Status::ok) return status;
        finish(y);
        h_ = h;
        return Status::ok;
    }

  private:
    /// Forgets earlier steps, and guesses from the index-1 form.
    Status begin(const Real& t, const Real& h, const Real* y) {
        newton_.forget(), scale_.forget(), past_.clear();
        scale_.weigh(y);
        x_.setZero();
        if (const Status status = system_.evaluate(t, y, system_.v(y), x_.data()); status != Status::ok) return status;
        x_.head(n_) *= h;
        remember();
        return rows_.start(t, y);
    }

    /// What the iteration has learnt holds for its weights.
    void weigh(const Real& t, const Real& h, const Real* y) {
        scale_.weigh(y);
        motion_ = scale_.of_motion(t, h, y);
        if (rows_.refresh(t, y)) newton_.forget();
        if (rows_.rebalance(motion_, h)) newton_.forget();
        places_ = rows_.of_places(h), step_ = abs(h);
        if (m_ == 0) return;
        weights_.segment(n_, m_) = rows_.weights();
        weights_.tail(m_) = rows_.weights_of_velocities();
    }

    void guess() { past_.guess(newton_.stiff() ? 0 : past_.best_degree(n_), turned_); }

    /// From the guess; where that leads nowhere, or to poses in which rows lose rank, from the last w without what is
    /// known of mu and nu, which leap beside such poses, and from an unchanged velocity: springs that are stiff make w
    /// swing.
    Status iterate() {
        guess();
        Status status = newton_.solve(*this, weights_, turned_.data());
        if (!leads_nowhere(status)) return status;
        newton_.forget();
        past_.guess(0, turned_);
        turned_.tail(2 * m_).setZero();
        status = newton_.solve(*this, weights_, turned_.data());
        if (!leads_nowhere(status)) return status;
        turned_.setZero();
        return newton_.solve(*this, weights_, turned_.data());
    }
    static bool leads_nowhere(Status status) {
        return status == Status::newton_failed || status == Status::singular_kkt;
    }

    /// An iteration fails near poses in which rows lose rank. If the guess is such a pose, the system names the joints.
    Status find_cause() {
        guess();
        take(turned_.data());
        equations_.place(x_.data());
        return equations_.prepare() == Status::singular_kkt ? Status::singular_kkt : Status::newton_failed;
    }

    void take(const Real* turned) {
        scale_.from_space(q_, turned, x_.data());
        std::copy_n(turned + n_, 2 * m_, x_.data() + n_);
    }

    Status residual(const Real* turned, Real* r) override {
        take(turned);
        const Status status = equations_.residual(x_.data(), r_.data());
        std::copy_n(r_.data() + n_, 2 * m_, r + n_);
        scale_.to_space(q_, r_.data(), r);
        return status;
    }
    Real size() const override {
        return max(max(motion_, places_), Real(step_ * scale_.of_velocity(equations_.rate().data())));
    }
    Real round_off() const override { return rows_.remoteness() * system_.kkt_round_off(); }

    /// What is linear in the constraints holds for the last w' = h f. Where something is stiff that has the round-off
    /// of large forces, and w is more accurate: mu and nu are then those for w.
    Status settle() {
        constexpr int most_corrections = 4;
        const bool stiff = scale_.of_velocity(r_.data()) > 64 * round_off() * size();
        if (!stiff) x_ -= r_;
        equations_.place(x_.data());
        for (int i = 0; stiff && m_ > 0 && i < most_corrections; ++i) {
            if (const Status status = equations_.correction(x_.data(), r_.data()); status != Status::ok) return status;
            x_ -= r_;
            equations_.place(x_.data());
        }
        return Status::ok;
    }

    void remember() {
        turned_.tail(2 * m_) = x_.tail(2 * m_);
        scale_.to_space(q_, x_.data(), turned_.data());
        past_.push(turned_);
    }

    void finish(Real* y) {
        const VecX& velocity = equations_.velocity(x_.data());
        remember();
        std::copy(equations_.configuration().begin(), equations_.configuration().end(), y);
        std::copy_n(velocity.data(), n_, system_.v(y));
    }

    System& system_;
    Eigen::Index n_, m_;
    MotionScale scale_;
    PositionWeights rows_;
    ProjectedMidpoint equations_;
    Newton newton_;
    Predictor past_;                 // of turned_
    VecX x_, r_, turned_, weights_;  // w, mu, nu; turned_ with w weighted and in space axes
    Real h_ = 0;                     // step that the memory belongs to; 0: none
    Real step_ = 0, motion_ = 0, places_ = 0;
    const Real* q_ = nullptr;
};

std::string why_not_projected(const System& system) {
    return system.position_constraints() < system.constraints() ? "rows without a position level (rolling)" : "";
}

Factory symmetric_midpoint() {
    Factory factory;
    factory.make = [](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<SymmetricMidpoint>(system);
    };
    factory.stages = 1;
    factory.declines = why_not_projected;
    return factory;
}

}  // namespace

KREISEL_METHOD(symmetric_midpoint(),
               {.name = "symmetric_projection/midpoint",
                .order = 2,
                .cites = {"hairer2000", "hairer2006", "munthekaas1998"},
                .summary = "implicit midpoint rule between two equal projections",
                .variable_cost = true,
                .form = Form::implicit,
                .meets_positions = true,
                .meets_velocities = true,
                .preserves = {{Property::symmetric, Domain::autonomous}, {Property::constraints, Domain::autonomous}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
