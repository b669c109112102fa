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
#include "methods/variational/rattle_family.hpp"
#include "methods/variational/rattle_increments.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class Rattlie final : public Integrator {
  public:
    Rattlie(System& system, std::unique_ptr<RattleEquations> equations)
        : system_(system),
          increments_(system, std::move(equations)),
          n_(system.velocities()),
          m_(system.constraints()),
          next_(static_cast<std::size_t>(system.group().size())),
          v_(VecX::Zero(n_)),
          lambda_(VecX::Zero(m_)) {}

    Status start(const Real&, const Real*) override {
        h_ = 0, stepped_ = false;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h == 0) return system_.accelerations(t, y, system_.v(y), v_.data(), nullptr);
        if (h != h_) {
            stepped_ = false;
            if (const Status status = increments_.begin(t, h, h / 2, y); status != Status::ok) return status;
        }
        h_ = 0;  // until this step has succeeded
        const Status status = advance(t, h, y);
        work_.newton_iterations = increments_.iterations();
        if (status != Status::ok) return status;
        h_ = h, end_ = t + h, stepped_ = true, least_norm_ = false;
        return Status::ok;
    }

    /// Of least norm, which is found here: most steps are never asked.
    const Real* multipliers() const override {
        if (!stepped_ || m_ == 0) return nullptr;
        if (!least_norm_) system_.minimise_multipliers(end_, next_.data(), lambda_.data());
        least_norm_ = true;
        return lambda_.data();
    }

  private:
    Status advance(const Real& t, const Real& h, Real* y) {
        if (const Status status = increments_.solve(t, h, y); status != Status::ok) return status;
        RattleEquations& equations = increments_.equations();
        if (const Status status = equations.finish(v_.data(), lambda_.data()); status != Status::ok) return status;
        increments_.remember();
        next_ = equations.configuration();
        std::copy(next_.begin(), next_.end(), y);
        std::copy_n(v_.data(), n_, system_.v(y));
        ++work_.exponentials;
        return Status::ok;
    }

    System& system_;
    RattleIncrements increments_;
    Eigen::Index n_, m_;
    std::vector<Real> next_;  // q+ of the last step, where its multipliers act; those of one that fails go elsewhere
    VecX v_;
    mutable VecX lambda_;
    Real h_ = 0, end_ = 0;
    bool stepped_ = false;
    mutable bool least_norm_ = true;
};

}  // namespace

std::unique_ptr<Integrator> make_rattlie(System& system, std::unique_ptr<RattleEquations> equations) {
    return std::make_unique<Rattlie>(system, std::move(equations));
}

KREISEL_METHOD(rattle_family(make_rattlie),
               {.name = "variational/rattlie",
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
