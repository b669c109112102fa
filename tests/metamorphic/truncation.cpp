// SPDX-License-Identifier: BSD-3-Clause
#include "tests/metamorphic/truncation.hpp"

#include <map>

#include "methods/contract/method.hpp"
#include "tests/metamorphic/judge.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

namespace {

/// The end of a motion by a method of order 4 with steps a sixteenth as long, on the constraints; cached for the next
/// method.
const Outcome& fine(const std::string& name, const Model& model, const Span& span) {
    static std::map<std::string, Outcome> known;
    const auto found = known.find(name);
    if (found != known.end()) return found->second;
    return known[name] = run(model, {"rkmk/rk4", "SO3xR3", "position_velocity"}, {span.h / 16, 16 * span.steps});
}

int declared_order(const Case& entry) {
    if (entry.combination.projection == "baumgarte_step") return 1;  // rates per step: an error of O(h) by any method
    const Method& bound = method(entry.combination.method);
    const OptionValues options = with_defaults(entry.combination.options, bound.factory.options);
    const Order order = bound.factory.order(options, bound.description.order);
    return std::min(order.configuration, order.velocity);
}

std::string beyond_errors(const Case& entry, const Transformed& changed, const RunPair& pair, const Real& apart,
                          int steps) {
    const Model& model = entry.model->model;
    const Real& h = entry.model->h;
    const Outcome& exact = fine(entry.model->name, model, {h, steps});
    const Outcome& other =
        fine(entry.model->name + ", " + entry.transformation->name, changed.model, {changed.time * h, steps});
    if (!exact.failure.empty() || !other.failure.empty())
        return "a fine run ends with " + exact.failure + other.failure;
    const Outcome other_back = changed.back(other);
    const Real rest = distance(exact, other_back, model);
    if (!(rest <= Real(1) / 100000)) return "fine runs differ by " + to_text(rest);
    const Real errors = distance(pair.original, exact, model) + distance(pair.changed, other_back, model);
    return apart <= errors + rest ? "" : to_text(apart) + " apart, with errors of " + to_text(errors);
}

}  // namespace

namespace {

/// Distance due to round-off: velocities of methods with multipliers are positions over h.
Real left_behind(const Case& entry, const Real& h, int steps) {
    const Real common = 2000 * epsilon * steps;
    if (!method(entry.combination.method).description.meets_constraints()) return common;
    return common * max(Real(1), Real(1 / (h * fastest_rate(entry.model->model))));
}

}  // namespace

std::string beyond_truncation(const Case& entry, const Transformed& changed, int steps, const Bench& bench) {
    constexpr int levels = 5;
    const Model& model = entry.model->model;
    std::string all;
    Real before = 0;
    for (int level = 0; level < levels; ++level) {
        const int factor = 1 << level;
        const Real h = entry.model->h / factor;
        const RunPair pair = run_both(model, changed, entry.combination, {h, factor * steps}, bench);
        if (!pair.original.failure.empty() || !pair.changed.failure.empty())
            return "ends with " + pair.original.failure + pair.changed.failure;
        const Real apart = distance(pair.original, pair.changed, model);
        if (level == 0 && !KREISEL_QUAD)
            if (const std::string found = beyond_errors(entry, changed, pair, apart, steps); !found.empty())
                return found;
        if (apart <= left_behind(entry, h, factor * steps)) return "";
        if (level >= 2 && log2(before / apart) >= declared_order(entry) - Real(3) / 10) return "";
        before = apart;
        all += (level > 0 ? ", " : "") + to_text(apart);
    }
    return "does not fall at the declared order: " + all;
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
