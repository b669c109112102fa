// SPDX-License-Identifier: BSD-3-Clause
//
// Observed orders on the forced heavy top, by the rule that certifies registered methods in the campaign.
#include "engine/reference/reference.hpp"
#include "tests/judges/methods/acceptance_curves.hpp"
#include "tests/judges/methods/checks.hpp"
#include "tests/judges/methods/runs.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using namespace stepping;

namespace {

const ReferenceSolution& exact() {
    static const ReferenceSolution solution = reference_solution(models::standard("forced_heavy_top"), 1);
    return solution;
}

/// Adds the errors after N steps of 1/N s; false if the run fails.
bool measure(const Method& entry, long steps, AcceptanceCurves& curves) {
    Trip trip(models::standard("forced_heavy_top"), "SO3xR3", entry);
    if (trip.run(1, steps) != Status::ok) return false;
    const auto add = [&](const char* metric, const Real& error, const Real& reference_error) {
        OrderCurve& curve = curves[metric];
        curve.points.push_back({steps, 1 / static_cast<double>(steps), to_double(error)});
        curve.reference_error = to_double(reference_error);
    };
    const Distance d = distance(trip.bodies(), exact().states);
    add("error.position", d.position, exact().position_error);
    add("error.rotation", d.rotation, exact().rotation_error);
    add("error.velocity", d.velocity, exact().velocity_error);
    add("error.omega", d.omega, exact().omega_error);
    return true;
}

}  // namespace

/// Two step sizes per octave: the reference is one in double, with an error bound of about 1e-11, which leaves a method
/// of order four two and a half octaves in which its error is 100 times larger.
AcceptanceCurves acceptance_curves(const Method& entry, bool first_order) {
    const long coarsest = first_order ? 4096 : 64, finest = 16 * coarsest;
    AcceptanceCurves curves;
    for (long steps = coarsest; steps <= finest; steps *= 2) {
        if (!measure(entry, steps, curves)) return {};
        if (steps < finest && !measure(entry, steps + steps / 2, curves)) return {};
    }
    return curves;
}

/// What double cannot show is observed in quad, tests/campaign/quad_orders.cpp.
Objection order_objection(const Method& entry) {
    if (!runs_on(entry, models::standard("forced_heavy_top"), "SO3xR3")) return "";
    const Order& order = entry.description.order;
    if (!is_seen_in_double(entry.description)) return "";
    const AcceptanceCurves curves = acceptance_curves(entry, order.configuration == 1);
    return curves.empty() ? "a run fails" : order_rule(curves, order, true);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
