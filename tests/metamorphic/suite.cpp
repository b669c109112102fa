// SPDX-License-Identifier: BSD-3-Clause
#include "tests/metamorphic/suite.hpp"

#include <cstdlib>

#include "methods/contract/method.hpp"
#include "tests/metamorphic/truncation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

namespace {

/// Or feeds them back.
bool solves_positions(const Combination& combination) {
    const ProjectionMethod& projector = projection(combination.projection);
    return method(combination.method).description.meets_constraints() || projector.description.positions ||
           projector.stabilises();
}

std::string beyond_round_off(const Case& entry, const RunPair& pair, const Transformed& changed, int steps,
                             Report& report) {
    if (pair.original.failure != pair.changed.failure)
        return "status \"" + pair.original.failure + "\" and \"" + pair.changed.failure + "\"";
    const Model& model = entry.model->model;
    const Real& h = entry.model->h;
    // Digits of x lost by the shift do not come back: sizes are those at the place of the run.
    Real far = 0;
    for (const Body& body : changed.model.bodies) far = max(far, Real(body.start.x.norm() / changed.length));
    far = max(far, max(pair.original.sizes.x, pair.changed.sizes.x));
    const bool solved = solves_positions(entry.combination);
    const growing::Growth& growth = growing::growth(entry.model->name, to_double(h), steps, solved);
    const Allowance allowed = allowance(model, pair.original.sizes, far, growth, solved ? h : Real(0));
    const Excess found = excess(pair, model, allowed, steps);
    Real& largest = report.largest[entry.transformation->name];
    if (found.ratio <= most_round_off) largest = max(largest, found.ratio);
    return found.ratio <= most_round_off ? "" : found.what + ", " + to_text(found.ratio) + " times kappa N eps s";
}

}  // namespace

std::string objection(const Case& entry, int steps, const Bench& bench, Report& report) {
    const Model& model = entry.model->model;
    const Transformed changed = *entry.transformation->apply(model);
    const Agreement agreement = entry.transformation->agreement(model, entry.combination);
    ++report.compared[to_text(agreement)];
    if (agreement == Agreement::truncation) return beyond_truncation(entry, changed, steps, bench);
    const RunPair pair = run_both(model, changed, entry.combination, {entry.model->h, steps}, bench);
    if (!pair.original.failure.empty()) return "the original ends with " + pair.original.failure;
    return agreement == Agreement::bits ? difference_in_bits(pair, model)
                                        : beyond_round_off(entry, pair, changed, steps, report);
}

Report compare_all(const std::vector<Case>& cases, int steps, const Bench& bench) {
    Report report;
    for (const Case& entry : cases) {
        const std::string found = objection(entry, steps, bench, report);
        const Exception* exception = exception_for(entry);
        if (exception) ++report.covered[exception->reason];
        if (found.empty()) continue;
        if (exception)
            ++report.excepted[exception->reason];
        else
            report.objections.push_back(to_text(entry) + ": " + found);
    }
    return report;
}

std::string to_text(const Report& report) {
    std::string text;
    std::size_t most = 60, shown = 0;
    if (std::getenv("KREISEL_METAMORPHIC_ALL")) most = report.objections.size();
    for (const std::string& line : report.objections)
        if (shown++ < most) text += line + "\n";
    if (report.objections.size() > most)
        text += "... and " + std::to_string(report.objections.size() - most) + " more\n";
    for (const auto& [name, count] : report.compared) text += std::to_string(count) + " comparisons, " + name + "\n";
    for (const auto& [name, ratio] : report.largest)
        text += "largest difference over kappa N eps s, " + name + ": " + std::to_string(to_double(ratio)) + "\n";
    for (const auto& [reason, count] : report.covered)
        text += std::to_string(count) + " excepted, " +
                std::to_string(report.excepted.contains(reason) ? report.excepted.at(reason) : 0) +
                " of them differ: " + reason + "\n";
    return text;
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
