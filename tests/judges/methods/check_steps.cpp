// SPDX-License-Identifier: BSD-3-Clause
//
// Judgements of steps against each other: counted, repeated, and reversed.
#include "tests/judges/methods/checks.hpp"
#include "tests/judges/methods/domains.hpp"
#include "tests/judges/methods/runs.hpp"
#include "tests/judges/methods/switched_system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using namespace stepping;

Objection solves_objection(const Method& entry) {
    if (entry.description.variable_cost) return "";
    return first_objection(entry, [&](const models::Named& named, const std::string& formulation) -> Objection {
        const auto inner = make_system(named.model, formulation);
        SwitchedSystem system(*inner, *inner);
        const auto integrator = entry.bind(system, default_options(entry.description.options));
        std::vector<Real> y = initial_state(*inner, named.model);
        const Real h = Real(1) / 1000;
        const int steps = KREISEL_QUAD ? 5 : 100;
        Status status = integrator->start(0, y.data());
        for (int i = 0; i < steps && status == Status::ok; ++i) status = integrator->step(h * i, h, y.data());
        if (status != Status::ok) return std::string("a run ends in ") + name(status);
        const long solves = entry.description.solves_at_start + steps * long{entry.description.stages};
        const long forces = steps * long{entry.description.force_evaluations};  // counted where there is no solve
        for (const auto& [found, declared] :
             {std::pair(system.solves, solves), std::pair(system.evaluations(), solves + forces)})
            if (found != declared)
                return std::to_string(found) + " solves or evaluations in " + std::to_string(steps) + " steps, " +
                       std::to_string(declared) + " declared";
        return "";
    });
}

Objection history_objection(const Method& entry) {
    return first_objection(entry, [&](const models::Named& named, const std::string& formulation) -> Objection {
        const Real t = Real(1) / 3, h = Real(1) / 1000;
        Trip fresh(named.model, formulation, entry), used(named.model, formulation, entry);
        const auto failure = [](const char* what, Status status) {
            return status == Status::ok ? Objection() : std::string(what) + " ends in " + name(status);
        };
        // In quad as many steps as fill the memory of any method, with the four of Adams-Bashforth.
        const int before = KREISEL_QUAD ? 5 : 10;
        if (const Objection run = failure("a run", used.run(before * h, before)); !run.empty()) return run;
        used.y = fresh.y;
        for (Trip* trip : {&fresh, &used}) {
            Status status = trip->integrator->start(t, trip->y.data());
            if (status == Status::ok) status = trip->integrator->step(t, h, trip->y.data());
            if (const Objection step = failure("a step", status); !step.empty()) return step;
        }
        return fresh.y == used.y ? "" : "a step depends on the steps before it";
    });
}

namespace {

/// Distance from the start after ten steps and the same ten backwards, relative to the largest entry of the start; not
/// finite where a step fails. In quad four: even of order ten a step that is not symmetric leaves 1e-22.
Real return_defect(const Model& model, const std::string& formulation, const Method& entry) {
    Trip trip(model, formulation, entry);
    const auto before = trip.y;
    const Real h = Real(1) / 512;
    bool ok = true;
    const int steps = KREISEL_QUAD ? 4 : 10;
    for (int i = 0; i < steps; ++i) ok = ok && trip.integrator->step(h * i, h, trip.y.data()) == Status::ok;
    for (int i = steps; i > 0; --i) ok = ok && trip.integrator->step(h * i, -h, trip.y.data()) == Status::ok;
    return ok ? largest_difference(before, trip.y) / max(Real(1), largest(before))
              : std::numeric_limits<Real>::infinity();
}

}  // namespace

Objection reversal_objection(const Method& entry) {
    const std::optional<Domain> claimed = claimed_domain(entry.description, Property::symmetric);
    if (!claimed) return "";
    return first_objection(entry, [&](const models::Named& named, const std::string& formulation) -> Objection {
        if (domain_of(named.model, *make_system(named.model, formulation)) > *claimed) return "";
        const Real defect = return_defect(named.model, formulation, entry);
        return defect <= 10000 * epsilon ? "" : "returns by " + to_text(defect) + " beside its start";
    });
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
