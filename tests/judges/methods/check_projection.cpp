// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/methods/checks.hpp"
#include "tests/judges/methods/runs.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using namespace stepping;

namespace {

/// A run whose projection is `entry`, registered or not.
Trip trip_with(const Model& model, const std::string& formulation, const ProjectionMethod& entry) {
    Trip trip(model, formulation, method("rkmk/rk4"));
    trip.project = entry.make(*trip.system, default_options(entry.description.options));
    return trip;
}

/// Moves everything but rotations, which would leave their group, off the constraints by about 1e-3.
void disturb(Trip& trip) {
    for (std::size_t i = 0; i < trip.y.size(); ++i) {
        const int stride = trip.system->group().size() / trip.system->bodies();
        const bool rotation = static_cast<int>(i) < trip.system->group().size() && static_cast<int>(i) % stride >= 3;
        if (!rotation) trip.y[i] += sin(Real(7 * static_cast<int>(i) + 2)) / 500;
    }
}

Objection objection_on(const ProjectionMethod& entry, const Model& model, const std::string& formulation) {
    Trip trip = trip_with(model, formulation, entry);
    const std::vector<Real> before = trip.y;
    if (trip.project->project(0, trip.y.data()) != Status::ok) return "fails on the constraints";
    if (!(largest_difference(before, trip.y) <= 100000 * epsilon)) return "moves what meets the constraints";
    if (trip.system->constraints() == 0) return "";
    disturb(trip);
    if (!(trip.position_defect() > Real(1) / 10000 && trip.velocity_defect() > Real(1) / 10000)) return "not disturbed";
    if (trip.project->project(0, trip.y.data()) != Status::ok) return "fails off the constraints";
    if (entry.description.positions && !(trip.position_defect() <= 1000 * epsilon)) return "leaves positions";
    if (entry.description.velocities && !(trip.velocity_defect() <= 10000 * epsilon)) return "leaves velocities";
    return "";
}

}  // namespace

Objection projection_objection(const ProjectionMethod& entry) {
    for (const models::Named& named : models::for_methods())
        for (const std::string& formulation : models::applicable(named.model)) {
            if (!runs_on(entry.description, named.model, formulation)) continue;
            const Objection objection = objection_on(entry, named.model, formulation);
            if (!objection.empty()) return objection + " (" + named.name + " as " + formulation + ")";
        }
    return "";
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
