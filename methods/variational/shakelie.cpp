// SPDX-License-Identifier: BSD-3-Clause
//
// SHAKELie, the variational method of SHAKE on a Lie group [hantearnold2021]: the discrete Euler-Lagrange equations of
// RATTLie (methods/variational/rattlie.cpp) in two increments, with one impulse at each configuration,
//   (d tau^{-1}_{h D_n})^T M D_n = (d tau^{-1}_{-h D_{n-1}})^T M D_{n-1} + h (f(t_n, q_n) - C(q_n)^T lambda_n),
//   q_{n+1} = q_n tau(h D_n),   Phi(t_{n+1}, q_{n+1}) = 0,
// and M v_n the mean of the momenta at q_n, before and after the impulse. Hence a step is one of RATTLie whose last
// equation, C v+ + b = 0, has given way to Phi(t+ + h, .) = 0 a step further on: it ends with the increment that the
// next one begins with, which saves an iteration and is not memory, for (q, v) determine that increment. The
// configurations are those of RATTLie; lambda is the mean of its two and of order 2, and v misses C v + b = 0 by
// O(h^2). Without joints the methods agree. The two-form does not see a difference C^T(.) of momenta while Phi = 0:
// symplectic as RATTLie is. Symmetric without joints only: a step back finds q, but v as it is after a step, and not at
// a start with C v + b = 0.
#include <algorithm>

#include "methods/variational/rattle_family.hpp"
#include "methods/variational/rattle_increments.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class Shakelie final : public Integrator {
  public:
    Shakelie(System& system, std::unique_ptr<RattleEquations> equations)
        : system_(system),
          increments_(system, std::move(equations)),
          n_(system.velocities()),
          m_(system.constraints()),
          next_(static_cast<std::size_t>(system.state_group().size())),
          v_(VecX::Zero(n_)),
          force_(v_),
          rate_(v_),
          lambda_(VecX::Zero(m_)) {}

    Status start(const Real&, const Real*) override {
        h_ = 0, stepped_ = false;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (h == 0) return system_.accelerations(t, y, system_.v(y), rate_.data(), nullptr);
        const bool first = h != h_ || !is_left(y);
        h_ = 0;  // until this step has succeeded
        Status status = first ? begin(t, h, y) : Status::ok;
        if (status == Status::ok) status = advance(t, h, first);
        work_.newton_iterations = increments_.iterations();
        if (status != Status::ok) {
            std::copy_n(y, system_.group().size(), next_.data());  // where the multipliers act
            return status;
        }
        std::copy_n(next_.data(), system_.group().size(), y);
        std::copy_n(v_.data(), n_, system_.v(y));
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
    /// Whether y is what the last step left: a projection, or a torsion spring whose turns are counted, may change it.
    bool is_left(const Real* y) const {
        return std::equal(y, y + system_.group().size(), next_.data()) &&
               std::equal(v_.data(), v_.data() + n_, system_.v(y));
    }

    /// The increment of the step from (q, v): half of the impulse at q is in v.
    Status begin(const Real& t, const Real& h, const Real* y) {
        stepped_ = false;
        const Status status = increments_.begin(t, h, h / 2, y);
        return status == Status::ok ? increments_.solve(t, h, y) : status;
    }

    /// From an increment to the next; next_ is (q+, w+), w+ the velocity before the impulse at q+.
    Status advance(const Real& t, const Real& h, bool first) {
        const std::vector<Real>& q = increments_.equations().configuration();
        Real* w = system_.v(next_.data());
        if (const Status status = increments_.equations().kick(w); status != Status::ok) return status;
        std::copy(q.begin(), q.end(), next_.begin());
        const Real end = t + h;
        Status status = first ? increments_.begin(end, h, h, next_.data()) : Status::ok;
        if (status == Status::ok) status = increments_.solve(end, h, next_.data());
        if (status != Status::ok) return status;
        increments_.remember();
        lambda_ = Eigen::Map<const VecX>(increments_.impulse(), m_) / h;
        finish_velocity(end, h, w);
        ++work_.exponentials;
        return Status::ok;
    }

    /// v+ = w+ - h/2 M^{-1} C(q+)^T lambda+.
    void finish_velocity(const Real& t, const Real& h, const Real* w) {
        v_ = Eigen::Map<const VecX>(w, n_);
        if (m_ == 0) return;
        const Real* q = next_.data();
        system_.apply_jacobian_transpose(t, q, lambda_.data(), force_.data());
        system_.solve_mass(q, force_.data(), rate_.data());
        v_ -= h / 2 * rate_;
    }

    System& system_;
    RattleIncrements increments_;
    Eigen::Index n_, m_;
    std::vector<Real> next_;
    VecX v_, force_, rate_;
    mutable VecX lambda_;
    Real h_ = 0, end_ = 0;
    bool stepped_ = false;
    mutable bool least_norm_ = true;
};

std::unique_ptr<Integrator> make_shakelie(System& system, std::unique_ptr<RattleEquations> equations) {
    return std::make_unique<Shakelie>(system, std::move(equations));
}

}  // namespace

KREISEL_METHOD(rattle_family(make_shakelie), {.name = "variational/shakelie",
                                              .order = 2,
                                              .cites = {"hantearnold2021"},
                                              .summary = "variational method SHAKELie, with multipliers of order 2",
                                              .force_evaluations = 1,
                                              .variable_cost = true,
                                              .form = Form::implicit,
                                              .reports_multipliers = true,
                                              .meets_positions = true,
                                              .preserves = {{Property::symplectic, Domain::constrained},
                                                            {Property::symmetric, Domain::potential},
                                                            {Property::momentum, Domain::constrained}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
