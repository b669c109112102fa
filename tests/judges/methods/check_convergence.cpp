// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/methods/checks.hpp"
#include "tests/judges/methods/runs.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using namespace stepping;

namespace {

/// x'' = 1000 (1 + x'^2): so fast that the equations of a long step have no real solution.
class Runaway final : public System {
  public:
    Runaway() : System(std::make_shared<AdditiveGroup>(1)) {}
    Status accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real*) override {
        applied_force(t, q, v, dv);
        return isfinite(*dv) ? Status::ok : Status::non_finite;
    }
    bool is_dissipative() const override { return true; }
    void applied_force(const Real&, const Real*, const Real* v, Real* f) const override { *f = 1000 * (1 + *v * *v); }
};

}  // namespace

Objection convergence_objection(const Method& entry) {
    if (!entry.description.is_implicit()) return "";
    Runaway system;
    if (entry.factory.declines && !entry.factory.declines(system).empty()) return "";  // has tests of its own
    const auto integrator = entry.bind(system, default_options(entry.description.options));
    std::vector<Real> y = {1, 0};
    const Status status = integrator->step(0, 1, y.data());
    if (status != Status::newton_failed) return std::string("a step without a solution ends as ") + name(status);
    return y == std::vector<Real>{1, 0} ? "" : "a step that fails moves the state";
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
