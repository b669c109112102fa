// SPDX-License-Identifier: BSD-3-Clause
//
// Adams-Bashforth methods on a group [faltinsen2001], written in backward differences of the slopes in the chart around
// the newest state: with gamma = 1, 1/2, 5/12, 3/8 [hairer1993, Sec. III.1],
//   log(y^{-1} y+) = h sum_m gamma_m nabla^m k~.
#include "tests/judges/steps/multistep/adams_bashforth_step.hpp"

#include "tests/judges/steps/dense_states.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// sum_m gamma_m nabla^m f for values f_0, f_1, ... from the newest one back.
VecX adams_sum(std::vector<VecX> f, int differences_left_out) {
    const Real gamma[] = {1, Real(1) / 2, Real(5) / 12, Real(3) / 8};
    VecX sum = VecX::Zero(f.front().size());
    const std::size_t used = f.size() - static_cast<std::size_t>(differences_left_out);
    for (std::size_t m = 0; m < used; ++m) {
        sum += gamma[m] * f.front();
        for (std::size_t j = 0; j + 1 < f.size(); ++j) f[j] -= f[j + 1];
        f.pop_back();
    }
    return sum;
}

void see_starting_step(RecordedRun& run, std::size_t step, Violations& found) {
    const RecordedState &now = run.states[step], &next = run.states[step + 1];
    const Method& rk4 = method("rkmk/rk4");
    const auto integrator = rk4.bind(run.system(), stepping::default_options(rk4.description.options));
    VecX y(now.q.size() + now.v.size());
    y << now.q, now.v;
    if (integrator->step(now.t, run.h, y.data()) != Status::ok) throw std::domain_error("a step of rkmk/rk4 fails");
    found.see("q+ of rkmk/rk4", run.bodies.increment(y.head(now.q.size()), next.q));
    found.see("v+ of rkmk/rk4", next.v - y.tail(now.v.size()));
}

void see_step(RecordedRun& run, std::size_t step, std::size_t k, const AdamsForm& form, Violations& found) {
    const RecordedState &now = run.states[step], &next = run.states[step + 1];
    const DenseStates states(run);
    std::vector<VecX> slopes;
    for (std::size_t j = 0; j < k; ++j) {
        const RecordedState& past = run.states[step - j];
        const VecX sigma = form.sign_of_sigma * states.increment(now, past);
        slopes.push_back(form.recentred ? states.pulled_back(sigma, states.slope(past)) : states.slope(past));
    }
    found.see("log(y^-1 y+) = h sum gamma nabla k~",
              states.increment(now, next) - run.h * adams_sum(slopes, form.differences_left_out));
}

constexpr const char* conditions_by_interpolation =
    "its order is that of the interpolation of slopes in one chart, whose differences the check of its steps writes "
    "out";

}  // namespace

Objection adams_bashforth_step_objection(const Method& method, int k, const AdamsForm& form) {
    const auto steps = static_cast<std::size_t>(k);
    for (const char* name : {"forced_heavy_top", "forced_free_body", "double_pendulum"})
        for (const std::string& formulation : models::applicable(models::standard(name))) {
            if (!stepping::runs_on(method, models::standard(name), formulation)) continue;
            RecordedRun run(method, stepping::default_options(method.description.options), models::standard(name),
                            formulation, Real(1) / 64, k + 2);
            Violations found;
            for (std::size_t i = 0; i + 1 < steps; ++i) see_starting_step(run, i, found);
            for (std::size_t i = steps - 1; i + 1 < run.states.size(); ++i) see_step(run, i, steps, form, found);
            const Objection objection = found.objection(equations_tolerance());
            if (!objection.empty()) return objection + " on " + name + " as " + formulation;
        }
    return "";
}

KREISEL_STEP_CHECK(
    "multistep/adams_bashforth2", [](const Method& method) { return adams_bashforth_step_objection(method, 2); },
    conditions_by_interpolation);
KREISEL_STEP_CHECK(
    "multistep/adams_bashforth3", [](const Method& method) { return adams_bashforth_step_objection(method, 3); },
    conditions_by_interpolation);
KREISEL_STEP_CHECK(
    "multistep/adams_bashforth4", [](const Method& method) { return adams_bashforth_step_objection(method, 4); },
    conditions_by_interpolation);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
