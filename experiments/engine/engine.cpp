// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/engine.hpp"

#include "experiments/engine/reference.hpp"
#include "experiments/engine/report.hpp"
#include "experiments/engine/run.hpp"
#include "mechanics/formulation.hpp"
#include "methods/method.hpp"
#include "methods/projection.hpp"
#include "problems/problem.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

template <class Registry>
auto descriptions(const Registry& registry) {
    std::vector<decltype(registry[0].description)> all;
    for (const auto& entry : registry) all.push_back(entry.description);
    return all;
}

class RealEngine final : public Engine {
  public:
    std::vector<ProblemDescription> problems() const override { return descriptions(kreisel::problems()); }
    std::vector<MethodDescription> methods() const override { return descriptions(kreisel::methods()); }
    std::vector<ProjectionDescription> projections() const override { return descriptions(kreisel::projections()); }
    std::vector<FormulationDescription> formulations() const override {
        std::vector<FormulationDescription> all;
        for (const Formulation& entry : kreisel::formulations()) all.push_back({entry.name, entry.summary});
        return all;
    }

    SystemSummary summary(const std::string& name, const ParameterValues& values,
                          const std::string& formulation_name) const override {
        const Model model = problem(name).build(Parameters(values));
        check_start(model);
        SystemSummary summary;
        summary.warnings = model.warnings;
        summary.skip_reason = formulation(formulation_name).why_not(model);
        if (!summary.skip_reason.empty()) return summary;
        const auto system = make_system(model, formulation_name);
        summary.bodies = system->bodies();
        summary.velocities = system->velocities();
        summary.constraints = system->constraints();
        for (const FirstIntegral& integral : system->integrals())
            summary.integrals.push_back({integral.name, integral.unit, integral.reason});
        return summary;
    }

    Order declared_order(const std::string& name, const OptionValues& options) const override {
        const Method& entry = method(name);
        return entry.factory.order(options, entry.description.order);
    }
    std::string skip_reason(const Cell& cell) const override { return why_skipped(cell); }
    Outcome run(const Cell& cell, const Reference* reference, const std::stop_token& stop) const override {
        return run_cell(cell, reference, stop);
    }

    Reference reference(const std::string& name, const ParameterValues& values, double t_end,
                        const std::stop_token& stop) const override {
        const Model model = problem(name).build(Parameters(values));
        const ReferenceSolution solution = reference_solution(model, decimal(t_end), stop);
        if (solution.interrupted) return {.state = {}, .error = {}, .interrupted = true};
        if (!solution.stopped.empty())
            return {.state = {}, .error = {}, .horizon = 0, .route = solution.route + ", stopped: " + solution.stopped};
        std::vector<std::string> bodies;
        for (const Body& body : model.bodies) bodies.push_back(body.name);
        Reference reference;
        reference.state = to_report(decimal(t_end), solution.states, bodies, solution.multipliers);
        reference.error = {{"error.position", to_number(solution.position_error)},
                           {"error.rotation", to_number(solution.rotation_error)},
                           {"error.velocity", to_number(solution.velocity_error)},
                           {"error.omega", to_number(solution.omega_error)},
                           {"error.multipliers", to_number(solution.multiplier_error)}};
        reference.horizon = to_double(solution.horizon);
        reference.route = solution.route;
        return reference;
    }
};

}  // namespace
}  // namespace KREISEL_PRECISION

#if KREISEL_QUAD
const Engine& engine_binary128() {
#else
const Engine& engine_binary64() {
#endif
    static const RealEngine engine;
    return engine;
}

}  // namespace kreisel
