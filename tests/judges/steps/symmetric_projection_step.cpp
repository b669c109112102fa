// SPDX-License-Identifier: BSD-3-Clause
//
// Symmetric projection [hairer2000]: from the two ends of a step, multipliers mu and nu by dense least squares such
// that the base method, which has checks of its own, leads from one displaced end to the other. What remains outside
// the ranges of the displacements is an objection.
#include "tests/judges/steps/recorded_steps.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class DisplacedStep {
  public:
    DisplacedStep(RecordedRun& run, const Method& base)
        : run_(run),
          now_(run.states[0]),
          next_(run.states[1]),
          base_(base.bind(run.system(), with_defaults({}, base.factory.options))),
          D_(displacements(now_)),
          D_next_(displacements(next_)),
          mu_(VecX::Zero(D_.cols())),
          nu_(mu_) {}

    /// How far the base method misses the displaced end, once no mu and nu do better.
    Violations violations() {
        const MatX A = D_ + D_next_;
        for (int i = 0; mu_.size() > 0 && i < (KREISEL_QUAD ? 40 : 20); ++i) {
            const auto [dq, dv] = missing();
            mu_ += solved_square(A.transpose() * A, A.transpose() * dq);
            nu_ += solved_square(A.transpose() * A, A.transpose() * dv);
        }
        const auto [dq, dv] = missing();
        Violations found;
        found.see("q+ = q* exp(D mu)", dq);
        found.see("v+ = v* + D nu", dv);
        found.see("Phi(q+) = 0", run_.position_defect(next_));
        found.see("C(q+) v+ + b = 0", run_.velocity_defect(next_));
        return found;
    }

  private:
    /// D(q) = M^{-1} C(q)^T.
    MatX displacements(const RecordedState& state) {
        MatX D = run_.position_rows(state).transpose();
        run_.solve_mass(state.q, D);
        return D;
    }

    /// From where the base method arrives to (q+ exp(-D+ mu), v+ - D+ nu).
    std::pair<VecX, VecX> missing() {
        const System& system = run_.system();
        std::vector<Real> y(static_cast<std::size_t>(system.state_group().size()));
        Eigen::Map<VecX>(y.data(), now_.q.size()) = run_.bodies.moved(now_.q, D_ * mu_);
        Eigen::Map<VecX>(y.data() + now_.q.size(), now_.v.size()) = now_.v + D_ * nu_;
        if (base_->start(now_.t, y.data()) != Status::ok || base_->step(now_.t, run_.h, y.data()) != Status::ok)
            throw std::domain_error("the base method failed");
        const VecX q = Eigen::Map<const VecX>(y.data(), now_.q.size());
        const VecX v = Eigen::Map<const VecX>(y.data() + now_.q.size(), now_.v.size());
        return {run_.bodies.increment(q, run_.bodies.moved(next_.q, -D_next_ * mu_)), next_.v - D_next_ * nu_ - v};
    }

    RecordedRun& run_;
    const RecordedState &now_, &next_;
    std::unique_ptr<Integrator> base_;
    MatX D_, D_next_;
    VecX mu_, nu_;
};

Objection symmetric_projection_objection(const Method& entry) {
    const std::string& name = entry.description.name;
    const Method& base = method("rkmk" + name.substr(name.find('/')));
    return on_models_with_and_without_joints(entry, {}, 1,
                                             [&](RecordedRun& run) { return DisplacedStep(run, base).violations(); });
}

KREISEL_STEP_CHECK("symmetric_projection/", symmetric_projection_objection);

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
