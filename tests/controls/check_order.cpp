// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/engine/reference.hpp"
#include "tests/controls/checks.hpp"
#include "tests/methods/stepping.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using namespace stepping;

namespace {

/// Rotation error on the forced heavy top after N steps, t = 1 s; not finite where the run fails.
double rotation_error(const Method& entry, long steps) {
    static const ReferenceSolution exact = reference_solution(models::standard("forced_heavy_top"), 1);
    Trip trip(models::standard("forced_heavy_top"), "SO3xR3", entry);
    if (trip.run(1, steps) != Status::ok) return std::numeric_limits<double>::infinity();
    return to_double(distance(trip.bodies(), exact.states).rotation);
}

}  // namespace

Objection order_objection(const Method& entry) {
    if (!runs_on(entry.description, "SO3xR3")) return "";
    const int p = entry.description.order.configuration;
    const long steps = p == 1 ? 16384 : 512;
    const double slope = std::log2(rotation_error(entry, steps) / rotation_error(entry, 2 * steps));
    if (slope >= p - 0.15) return "";
    return "observed order " + std::to_string(slope) + " of " + std::to_string(p);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
