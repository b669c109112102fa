// SPDX-License-Identifier: BSD-3-Clause
#include "engine/engine.hpp"

#include "engine/linearised/linearise.hpp"
#include "engine/metrics/metric.hpp"
#include "engine/reference/reference.hpp"
#include "engine/reference/taylor/taylor_route.hpp"
#include "engine/report/report.hpp"
#include "engine/run.hpp"
#include "engine/scheme_rows.hpp"
#include "engine/skip.hpp"
#include "mechanics/formulation.hpp"
#include "mechanics/joints/joint_rows.hpp"
#include "mechanics/start.hpp"
#include "mechanics/start_warnings.hpp"
#include "methods/contract/method.hpp"
#include "methods/contract/projection.hpp"
#include "problems/problem.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

template <class Registry>
auto descriptions(const Registry& registry) {
    std::vector<decltype(registry[0].description)> all;
    all.reserve(registry.size());
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

    std::vector<MetricDescription> metrics() const override { return descriptions(kreisel::metrics()); }

    SystemSummary summary(const std::string& name, const ParameterValues& values,
                          const std::string& formulation_name) const override {
        const Model model = problem(name).build(Parameters(values));
        check_start(model);
        SystemSummary summary;
        summary.warnings = model.warnings;
        for (const std::string& warning : start_warnings(model)) summary.warnings.push_back(warning);
        summary.skip_reason = formulation(formulation_name).why_not(model);
        if (!summary.skip_reason.empty()) return summary;
        const auto system = make_system(model, formulation_name);
        summary.bodies = system->bodies();
        summary.velocities = system->velocities();
        summary.constraints = to_summary(system->constraint_rank());
        for (const ConstraintRow& row : system->constraint_rows())
            summary.constraints.directions += row.direction ? 1 : 0;
        for (const FirstIntegral& integral : system->integrals())
            summary.integrals.push_back({integral.name, integral.unit, integral.reason});
        return summary;
    }

    Order declared_order(const std::string& name, const OptionValues& options) const override {
        const Method& entry = method(name);
        return entry.factory.order(options, entry.description.order);
    }
    std::vector<SchemeRow> scheme(const std::string& name) const override {
        return scheme_rows(method(name).factory.scheme);
    }
    std::string skip_reason(const Cell& cell) const override { return why_skipped(cell); }
    Outcome run(const Cell& cell, const Reference* reference, const std::stop_token& stop,
                SampleSink* samples) const override {
        return run_cell(cell, reference, stop, samples);
    }

    Reference reference(const std::string& name, const ParameterValues& values, double t_end,
                        const std::stop_token& stop) const override {
        const Problem& entry = problem(name);
        const Model model = entry.build(Parameters(values));
        ReferenceSolution solution = confirmed_reference(model, decimal(t_end), stop);
        if (solution.interrupted) return {.state = {}, .error = {}, .interrupted = true};
        if (!solution.stopped.empty())
            return {.state = {}, .error = {}, .horizon = 0, .route = solution.route + ", stopped: " + solution.stopped};
        if (entry.closed_form) {
            allow_for(solution, distance(solution.states, entry.closed_form(Parameters(values), decimal(t_end))));
            solution.route += "; closed form";
        }
        Reference reference;
        reference.state = to_report(decimal(t_end), solution.states, model, solution.multipliers, solution.angles);
        if (solution.compared) {
            // Past the horizon, the multipliers' difference at the end by itself means nothing.
            const bool agreed = !solution.multipliers.empty() && abs(solution.horizon) >= abs(decimal(t_end));
            reference.error = errors_of(
                {{solution.position_error, solution.rotation_error, solution.velocity_error, solution.omega_error},
                 agreed ? solution.multiplier_error : Separation::unknown_multipliers()},
                constraint_rows(model));
        }
        reference.horizon = to_double(solution.horizon);
        reference.route = solution.route;
        return reference;
    }

    ReferenceCheck check_reference(const std::string& name, const ParameterValues& values,
                                   const Reference& reference) const override {
        if (reference.state.bodies.empty()) return {.difference = {}, .failure = "it has no state: " + reference.route};
        if (reference.state.t.value > reference.horizon)
            return {.difference = {}, .failure = "it lies past its horizon"};
        const Model model = problem(name).build(Parameters(values));
        TaylorRoute route(model);
        std::vector<Real> lambda, exact;
        Status status = route.advance(from_number(reference.state.t), {});
        if (status == Status::ok) status = route.multipliers(lambda);
        if (status != Status::ok)
            return {.difference = {}, .failure = std::string("Taylor series: ") + kreisel::name(status)};
        for (const Number& row : reference.state.multipliers) exact.push_back(from_number(row));
        Separation apart{distance(route.states(), from_report(reference.state))};
        const auto rows = constraint_rows(model);
        if (exact.size() == rows.size() && lambda.size() == rows.size())
            apart.multipliers = multiplier_distance(rows, lambda, exact);
        return {.difference = errors_of(apart, rows), .failure = ""};
    }

    Linearisation linearise(const std::string& name, const ParameterValues& values,
                            const std::string& formulation_name) const override {
        const Model model = problem(name).build(Parameters(values));
        check_start(model);
        Linearisation none;
        none.skip_reason = formulation(formulation_name).why_not(model);
        return none.skip_reason.empty() ? linearised(model, formulation_name) : none;
    }

    std::string reference_digest() const override { return KREISEL_REFERENCE_DIGEST; }
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
