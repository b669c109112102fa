// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/methods/checks.hpp"
#include "tests/judges/methods/runs.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using namespace stepping;

namespace {

/// A run whose projection is `entry`, registered or not.
Trip trip_with(const Model& model, const std::string& formulation, const ProjectionMethod& entry,
               const OptionValues& options = {}) {
    Trip trip(model, formulation, method("rkmk/rk4"));
    trip.project = entry.make(*trip.system, with_defaults(options, entry.description.options));
    return trip;
}

/// Moves everything but rotations, which would leave their group, off the constraints by about 1e-3 times `size`.
void disturb(Trip& trip, const Real& size = 1) {
    for (std::size_t i = 0; i < trip.y.size(); ++i) {
        const int stride = trip.system->group().size() / trip.system->bodies();
        const bool rotation = static_cast<int>(i) < trip.system->group().size() && static_cast<int>(i) % stride >= 3;
        if (!rotation) trip.y[i] += size * sin(Real(7 * static_cast<int>(i) + 2)) / 500;
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

bool has_option(const ProjectionMethod& entry, const std::string& name) {
    const auto& options = entry.description.options;
    return std::any_of(options.begin(), options.end(), [&](const OptionDescription& o) { return o.name == name; });
}

/// What one iteration leaves of the positions after a disturbance of this size; negative where it fails.
Real left_by_one(const ProjectionMethod& entry, const Real& size) {
    Trip trip = trip_with(models::standard("double_pendulum"), "SO3xR3", entry, {{"iterations", "one"}});
    disturb(trip, size);
    const Status status = trip.project->project(0, trip.y.data());
    return status == Status::ok ? trip.position_defect() : Real(-1);
}

}  // namespace

Objection iterations_objection(const ProjectionMethod& entry) {
    // Spherical rows are linear in ambient coordinates: there the first iteration is the last.
    if (!has_option(entry, "iterations") || entry.description.ambient) return "";
    const Real all = left_by_one(entry, 1), half = left_by_one(entry, Real(1) / 2);
    if (all < 0 || half < 0) return "one iteration fails";
    if (!(all > 10000 * epsilon)) return "goes on after one iteration";
    return 3 * half <= all ? "" : "one iteration leaves more than the square of the defect";
}

Objection every_objection(const ProjectionMethod& entry) {
    if (!has_option(entry, "every")) return "";
    Trip trip = trip_with(models::standard("double_pendulum"), "SO3xR3", entry, {{"every", 3L}});
    trip.project->start();
    disturb(trip);
    const std::vector<Real> off = trip.y;
    const auto acts = [&] {
        trip.y = off;
        return trip.project->project(0, trip.y.data()) != Status::ok || trip.y != off;
    };
    if (acts() || acts()) return "acts before the third step";
    if (!acts()) return "does not act at the third step";
    trip.project->retract();
    if (!acts()) return "counts a step that is not taken";
    if (acts()) return "acts at the fourth step";
    trip.project->start();
    return acts() || acts() || !acts() ? "does not begin to count at the start" : "";
}

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
