// SPDX-License-Identifier: BSD-3-Clause
//
// RATTLie, the variational method of RATTLE on a Lie group [hantearnold2021]: with p = M v, tau = exp or cay, and f the
// conservative force,
//   (d tau^{-1}_{hD})^T M D = p + h/2 (f(t, q) - C(q)^T lambda'),    q+ = q tau(h D),    Phi(t+, q+) = 0,
//   p+ = (d tau^{-1}_{-hD})^T M D + h/2 (f(t+, q+) - C(q+)^T lambda+),    C(q+) v+ + b = 0,
// d tau being right-trivialised. Gyroscopic terms are not evaluated: the transposes carry momentum along. Without
// constraints it is the Lie-Verlet method of [bourabeemarsden2009], with Cayley coordinates explicit but for three
// unknowns of each body. Symmetric; symplectic where f has a potential. lambda' belongs to the beginning of the step
// and lambda+ to its end: lambda+, which is reported, is of order 1.
//
// Unknowns of the iteration are D and mu = h/2 lambda'.
#include "methods/contract/integrator.hpp"
#include "methods/implicit/motion_scale.hpp"
#include "methods/implicit/newton.hpp"
#include "methods/implicit/position_weights.hpp"
#include "methods/implicit/predictor.hpp"
#include "methods/variational/rattle_equations.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class Rattlie final : public Integrator, private Equations {
  public:
    Rattlie(System& system, IncrementChart chart)
        : system_(system),
          equations_(system, chart),
          n_(system.velocities()),
          m_(system.constraints()),
          scale_(system),
          rows_(system, scale_),
          newton_(n_ + m_),
          past_(n_ + m_),
          unknowns_(VecX::Zero(n_ + m_)),
          turned_(unknowns_),
          weights_(VecX::Ones(n_ + m_)),
          difference_(VecX::Zero(n_)),
          v_(difference_),
          lambda_(VecX::Zero(m_)),
          bias_(lambda_) {}

    Status start(const Real&, const Real*) override {
        h_ = 0, stepped_ = false;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h == 0) return system_.accelerations(t, y, system_.v(y), v_.data(), nullptr);
        q_ = y;
        if (h != h_)
            if (const Status status = begin(t, h, y); status != Status::ok) return status;
        h_ = 0;  // until this step has succeeded
        const Status status = advance(t, h, y);
        work_.newton_iterations = newton_.iterations();
        if (status != Status::ok) return status;
        h_ = h, end_ = t + h, stepped_ = true, least_norm_ = false;
        return Status::ok;
    }

    /// Of least norm, which is found here: most steps are never asked.
    const Real* multipliers() const override {
        if (!stepped_ || m_ == 0) return nullptr;
        if (!least_norm_) system_.minimise_multipliers(end_, equations_.configuration().data(), lambda_.data());
        least_norm_ = true;
        return lambda_.data();
    }

  private:
    /// Guesses from the index-1 form: D = v + h/2 v', mu = h/2 lambda.
    Status begin(const Real& t, const Real& h, const Real* y) {
        newton_.forget(), scale_.forget(), past_.clear();
        stepped_ = false;
        scale_.weigh(y);
        const Real* v = system_.v(y);
        if (const Status status = index_one(t, y, v); status != Status::ok) return status;
        unknowns_.head(n_) = Eigen::Map<const VecX>(v, n_) + h / 2 * unknowns_.head(n_);
        unknowns_.tail(m_) = h / 2 * lambda_;
        remember();
        return rows_.start(t, y);
    }

    /// v' in the unknowns, and some lambda: without the search for those of least norm, which allocates.
    Status index_one(const Real& t, const Real* y, const Real* v) {
        if (m_ == 0) return system_.accelerations(t, y, v, unknowns_.data(), nullptr);
        if (const Status status = system_.prepare_kkt(t, y); status != Status::ok) return status;
        system_.count_evaluation();
        system_.applied_force(t, y, v, v_.data());
        system_.gyroscopic_force(y, v, difference_.data());
        v_ += difference_;
        system_.acceleration_bias(t, y, v, bias_.data());
        return system_.solve_prepared(t, y, v_.data(), bias_.data(), unknowns_.data(), lambda_.data());
    }

    Status advance(const Real& t, const Real& h, Real* y) {
        scale_.weigh(y);
        motion_ = scale_.of_motion(t, h, y);
        if (!isfinite(motion_)) return Status::non_finite;
        if (rows_.refresh(t, y)) newton_.forget();
        if (rows_.rebalance(motion_, h)) newton_.forget();
        if (m_ > 0) weights_.tail(m_) = rows_.weights();
        equations_.begin(t, h, y, system_.v(y));
        size_ = max(motion_, rows_.of_places(h));
        if (const Status status = iterate(y); status != Status::ok) return status;
        if (const Status status = equations_.finish(v_.data(), lambda_.data()); status != Status::ok) return status;
        remember();
        std::copy(equations_.configuration().begin(), equations_.configuration().end(), y);
        std::copy_n(v_.data(), n_, system_.v(y));
        ++work_.exponentials;
        return Status::ok;
    }

    /// From the guess, and where that leads nowhere from an unchanged velocity.
    Status iterate(const Real* y) {
        past_.guess(newton_.stiff() ? 0 : past_.best_degree(n_), turned_);
        Status status = newton_.solve(*this, weights_, turned_.data());
        if (status != Status::newton_failed) return status;
        turned_.setZero();
        scale_.to_space(q_, system_.v(y), turned_.data());
        return newton_.solve(*this, weights_, turned_.data());
    }

    Status residual(const Real* turned, Real* r) override {
        system_.count_evaluation();
        scale_.from_space(q_, turned, unknowns_.data());
        std::copy_n(turned + n_, m_, unknowns_.data() + n_);
        const Status status = equations_.residual(unknowns_.data(), r);
        if (status != Status::ok) return status;
        scale_.to_space(q_, r, r);
        return status;
    }

    Real size() const override { return size_; }
    Real round_off() const override { return rows_.remoteness() * system_.kkt_round_off(); }

    void remember() {
        turned_.tail(m_) = unknowns_.tail(m_);
        scale_.to_space(q_, unknowns_.data(), turned_.data());
        past_.push(turned_);
    }

    System& system_;
    RattleEquations equations_;
    Eigen::Index n_, m_;
    MotionScale scale_;
    PositionWeights rows_;
    Newton newton_;
    Predictor past_;                    // of turned_
    VecX unknowns_, turned_, weights_;  // D, mu; the same with D weighted and in space axes
    VecX difference_, v_;
    mutable VecX lambda_;
    VecX bias_;  // xi
    Real h_ = 0, end_ = 0, motion_ = 0, size_ = 0;
    bool stepped_ = false;
    mutable bool least_norm_ = true;
    const Real* q_ = nullptr;
};

std::string why_not_variational(const System& system) {
    if (system.is_dissipative()) return "forces that depend on velocities (dampers)";
    if (system.position_constraints() < system.constraints()) return "rows without a position level (rolling)";
    return "";
}

Factory rattlie() {
    Factory factory;
    factory.options = {{.name = "coordinates",
                        .summary = "of increments: exponential or Cayley map",
                        .standard = std::string("exp"),
                        .choices = {"exp", "cayley"}}};
    factory.make = [](System& system, const OptionValues& options, const MethodDescription&) {
        const bool cayley = std::get<std::string>(options.at("coordinates")) == "cayley";
        return std::make_unique<Rattlie>(system, cayley ? IncrementChart::cayley : IncrementChart::exp);
    };
    factory.declines = why_not_variational;
    return factory;
}

}  // namespace

KREISEL_METHOD(rattlie(), {.name = "variational/rattlie",
                           .order = Order(2, 2, 1),
                           .cites = {"hantearnold2021", "bourabeemarsden2009"},
                           .summary = "variational method RATTLie, Lie-Verlet where nothing is constrained",
                           .force_evaluations = 2,
                           .variable_cost = true,
                           .form = Form::implicit,
                           .reports_multipliers = true,
                           .meets_positions = true,
                           .meets_velocities = true,
                           .preserves = {{Property::symplectic, Domain::constrained},
                                         {Property::symmetric, Domain::constrained},
                                         {Property::momentum, Domain::constrained},
                                         {Property::constraints, Domain::constrained}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
