// SPDX-License-Identifier: BSD-3-Clause
#include "tests/metamorphic/truncation.hpp"

#include <map>

#include "experiments/engine/reference.hpp"
#include "methods/method.hpp"
#include "tests/metamorphic/judge.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

namespace {

/// The reference of a model at a time; kept for the next method.
const Outcome& reference_of(const std::string& name, const Model& model, const Real& t) {
    static std::map<std::string, Outcome> known;
    const auto found = known.find(name);
    if (found != known.end()) return found->second;
    const ReferenceSolution solution = reference_solution(model, t);
    Outcome outcome;
    outcome.failure = solution.stopped;
    outcome.bodies = solution.states;
    return known[name] = outcome;
}

int declared_order(const Case& entry) {
    const Method& bound = method(entry.combination.method);
    OptionValues options = entry.combination.options;
    for (const OptionDescription& option : bound.factory.options) options.insert({option.name, option.standard});
    const Order order = bound.factory.order(options, bound.description.order);
    return std::min(order.configuration, order.velocity);
}

std::string beyond_errors(const Case& entry, const Transformed& changed, const Pair& pair, const Real& apart,
                          int steps) {
    const Model& model = entry.model->model;
    const Real t = entry.model->h * steps;
    const Outcome& exact = reference_of(entry.model->name, model, t);
    const std::string name = entry.model->name + ", " + entry.transformation->name;
    const Outcome& other = reference_of(name, changed.model, changed.time * t);
    if (!exact.failure.empty() || !other.failure.empty())
        return "a reference ends with " + exact.failure + other.failure;
    const Outcome other_back = changed.back(other);
    if (!(distance(exact, other_back, model) <= Real(1) / 10000000000)) return "the references differ";
    const Real errors = distance(pair.original, exact, model) + distance(pair.changed, other_back, model);
    return apart <= errors + Real(1) / 10000000000 ? "" : to_text(apart) + " apart, with errors of " + to_text(errors);
}

}  // namespace

std::string beyond_truncation(const Case& entry, const Transformed& changed, int steps, const Bench& bench) {
    const Model& model = entry.model->model;
    Real apart[3];
    for (int level = 0; level < 3; ++level) {
        const int factor = 1 << level;
        const Pair pair = run_both(model, changed, entry.combination, {entry.model->h / factor, factor * steps}, bench);
        if (!pair.original.failure.empty() || !pair.changed.failure.empty())
            return "ends with " + pair.original.failure + pair.changed.failure;
        apart[level] = distance(pair.original, pair.changed, model);
        if (level == 0 && !KREISEL_QUAD)
            if (const std::string found = beyond_errors(entry, changed, pair, apart[0], steps); !found.empty())
                return found;
    }
    // Round-off over so short a motion.
    if (apart[2] <= 2000 * epsilon * steps) return "";
    const Real slope = log2(apart[0] / apart[2]) / 2;
    return slope >= declared_order(entry) - Real(3) / 10
               ? ""
               : "falls at order " + std::to_string(to_double(slope)) + ": " + to_text(apart[0]) + ", " +
                     to_text(apart[1]) + ", " + to_text(apart[2]);
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
