// SPDX-License-Identifier: BSD-3-Clause
//
// Whether a method preserves what it claims to, on the smallest systems of each class: a free body, one about a fixed
// point in a potential, two bodies with joints.
#include "engine/structure/symplecticity.hpp"
#include "mechanics/model/scales.hpp"
#include "tests/judges/methods/domains.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using namespace stepping;

namespace {

/// A top on which no motion is special, at some rad/s.
Model oblique_top() {
    Model model = models::standard("heavy_top");
    Body& body = model.bodies[0];
    const Vec3 lever = -model.joints[0].r_second, omega(1, Real(3) / 2, Real(-1) / 2);
    const Mat3 R = SO3::exp(Vec3(2, -5, 3) / 5);
    body.start = {R * lever, R, R * omega.cross(lever), omega};
    return model;
}

const std::vector<Model>& smallest_models() {
    static const std::vector<Model> all = {models::standard("free_top"), oblique_top(),
                                           models::standard("double_pendulum")};
    return all;
}

/// The first objection of `judge(trip)` on the smallest systems of a claimed class, from their start.
template <class F>
Objection claimed_objection(const Method& entry, Property property, F judge) {
    const std::optional<Domain> claimed = claimed_domain(entry.description, property);
    if (!claimed) return "";
    int judged = 0;
    for (const Model& model : smallest_models())
        for (const std::string& formulation : models::applicable(model)) {
            if (!runs_on(entry, model, formulation)) continue;
            Trip trip(model, formulation, entry);
            const Domain domain = domain_of(model, *trip.system);
            if (domain > *claimed) continue;
            ++judged;
            const Objection objection = judge(trip);
            if (!objection.empty())
                return std::string(name(property)) + ": " + objection + " (" + model.bodies[0].name + ", " +
                       name(domain) + ", as " + formulation + ")";
        }
    return judged > 0 ? "" : std::string(name(property)) + ": it runs on no system that could show it";
}

Objection two_form_objection(Trip& trip) {
    const Step step = [&](const Real& t, const Real& h, Real* y) {
        const Status status = trip.integrator->start(t, y);
        return status == Status::ok ? trip.integrator->step(t, h, y) : status;
    };
    for (const int n : {16, 32, 64}) {
        const Real h = Real(1) / n;
        const StepDefect defect = symplecticity_defect({*trip.system, step, extent(trip.model), 0, h, trip.y.data()});
        if (!isfinite(defect.uncertainty)) return defect.why_not;
        if (!(defect.value <= 10 * defect.uncertainty))
            return "a step by " + to_text(h) + " changes the two-form by " + to_text(defect.value) + ", known to " +
                   to_text(defect.uncertainty);
    }
    return "";
}

/// Of integrals whose name contains `part`: drift over 50 steps relative to the sizes of their terms.
Objection drift_objection(Trip& trip, const std::string& part) {
    std::vector<const FirstIntegral*> integrals;
    for (const FirstIntegral& integral : trip.system->integrals())
        if (integral.name.starts_with(part)) integrals.push_back(&integral);
    const std::vector<BodyState> before = trip.bodies();
    if (const Status status = trip.run(Real(50) / 32, 50); status != Status::ok)
        return std::string("a run ends in ") + name(status);
    const std::vector<BodyState> after = trip.bodies();
    for (const FirstIntegral* integral : integrals) {
        const Real size = max(integral->size({before}), integral->size({after}));
        const Real drift = abs(integral->value({after}) - integral->value({before}));
        if (!(drift <= 4000 * epsilon * size)) return integral->name + " changes by " + to_text(drift) + " in 50 steps";
    }
    return "";
}

Objection constraint_drift(Trip& trip) {
    if (trip.system->constraints() == 0) return "";
    if (const Status status = trip.run(Real(20) / 128, 20); status != Status::ok)
        return std::string("a run ends in ") + name(status);
    const Real positions = trip.position_defect(), velocities = trip.velocity_defect();
    if (positions <= 1000 * epsilon && velocities <= 10000 * epsilon) return "";
    return "they are off by " + to_text(positions) + " m and " + to_text(velocities) + " m/s after 20 steps";
}

}  // namespace

Objection symplecticity_objection(const Method& entry) {
    if (claimed_domain(entry.description, Property::symplectic) && entry.description.keeps_memory)
        return "symplectic: its steps are not maps of states, they remember others";
    return claimed_objection(entry, Property::symplectic, two_form_objection);
}

Objection momentum_objection(const Method& entry) {
    for (const char* part : {"angular_momentum", "momentum"}) {
        const Objection found =
            claimed_objection(entry, Property::momentum, [&](Trip& trip) { return drift_objection(trip, part); });
        if (!found.empty()) return found;
    }
    return "";
}

Objection energy_objection(const Method& entry) {
    return claimed_objection(entry, Property::energy, [](Trip& trip) { return drift_objection(trip, "energy"); });
}

Objection constraints_objection(const Method& entry) {
    return claimed_objection(entry, Property::constraints, constraint_drift);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
