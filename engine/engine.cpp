// SPDX-License-Identifier: BSD-3-Clause
#include "engine/engine.hpp"

#include "engine/begin.hpp"
#include "engine/linearised/linearise.hpp"
#include "engine/metrics/metric.hpp"
#include "engine/report/geometry.hpp"
#include "engine/report/report.hpp"
#include "engine/reported_reference.hpp"
#include "engine/run.hpp"
#include "engine/scheme_rows.hpp"
#include "engine/skip.hpp"
#include "engine/stability/test_rotation.hpp"
#include "mechanics/formulation.hpp"
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
        for (const Formulation& entry : kreisel::formulations())
            all.push_back({entry.name, entry.summary, entry.cites});
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

    BeginCheck check_begin(const std::string& name, const ParameterValues& values, const std::string& formulation_name,
                           const BeginState& begin) const override {
        return checked_begin(problem(name).build(Parameters(values)), formulation_name, begin);
    }

    Geometry geometry(const std::string& name, const ParameterValues& values) const override {
        return to_geometry(problem(name).build(Parameters(values)));
    }

    MethodDescription method(const std::string& name, const OptionValues& options) const override {
        return kreisel::method(name).under(options);
    }
    std::vector<SchemeRow> scheme(const std::string& name) const override {
        return scheme_rows(kreisel::method(name).factory.scheme);
    }
    RotationStability stability(const std::string& name) const override {
        const Method& entry = kreisel::method(name);
        return rotation_stability(entry, with_defaults({}, entry.description.options));
    }
    std::string skip_reason(const Cell& cell) const override { return why_skipped(cell); }
    Outcome run(const Cell& cell, const Reference* reference, const Watch& watch, SampleSink* samples) const override {
        return run_cell(cell, reference, watch, samples);
    }

    std::optional<double> run_time(const Cell& cell, const Watch& watch) const override {
        return time_cell(cell, watch);
    }

    using Engine::reference;
    Reference reference(const std::string& name, const ParameterValues& values, const BeginState* begin, double t_end,
                        long samples, const Watch& watch) const override {
        return reported_reference(problem(name), values, begin, t_end, samples, watch);
    }
    using Engine::check_reference;
    ReferenceCheck check_reference(const std::string& name, const ParameterValues& values, const BeginState* begin,
                                   const Reference& reference) const override {
        return checked_reference(problem(name), values, begin, reference);
    }

    Linearisation linearise(const std::string& name, const ParameterValues& values, const std::string& formulation_name,
                            const BeginState* begin) const override {
        const Model model = problem(name).build(Parameters(values));
        check_start(model);
        Linearisation none;
        none.skip_reason = formulation(formulation_name).why_not(model);
        if (!none.skip_reason.empty()) return none;
        if (!begin) return linearised(model, formulation_name);
        none.refusal = checked_begin(model, formulation_name, *begin).fault;
        return none.refusal.empty() ? linearised(model, formulation_name, moved_to(model, *begin)) : none;
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
