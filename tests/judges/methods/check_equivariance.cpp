// SPDX-License-Identifier: BSD-3-Clause
//
// Left translation: if gravity, anchors, loads fixed in space and start are moved by a rigid motion of space, so is the
// result.
#include "tests/judges/methods/checks.hpp"
#include "tests/judges/methods/runs.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using namespace stepping;

namespace {

/// x -> Q x + p.
struct RigidMotion {
    Mat3 Q = SO3::exp(Vec3(Real(1) / 3, Real(-6) / 5, Real(3) / 4));
    Vec3 p = Vec3(Real(1) / 4, Real(-1) / 2, Real(3) / 4);

    Vec3 point(const Vec3& x) const { return Q * x + p; }
    BodyState operator()(const BodyState& s) const { return {point(s.x), Q * s.R, Q * s.v, s.omega}; }
    Model operator()(Model model) const {
        for (Body& body : model.bodies) body.start = (*this)(body.start);
        for (Joint& joint : model.joints) {
            if (joint.first == ground) joint.r_first = point(joint.r_first), joint.axes_first = Q * joint.axes_first;
            if (joint.second == ground)
                joint.r_second = point(joint.r_second), joint.axes_second = Q * joint.axes_second;
        }
        for (Spring& spring : model.springs) {
            if (spring.first == ground) spring.r_first = point(spring.r_first);
            if (spring.second == ground) spring.r_second = point(spring.r_second);
        }
        for (TorsionSpring& spring : model.torsion_springs) {
            if (spring.first == ground) spring.axes_first = Q * spring.axes_first;
            if (spring.second == ground) spring.axes_second = Q * spring.axes_second;
        }
        for (Load& load : model.loads)
            if (load.axes == Load::Axes::space) load.force = Q * load.force, load.torque = Q * load.torque;
        model.gravity.g = Q * model.gravity.g;
        return model;
    }
};

/// Largest entry of the difference, relative to the sizes of the quantities; that of velocities is at least `rate`.
Real relative_difference(const std::vector<BodyState>& a, const std::vector<BodyState>& b, const Real& rate) {
    Real length = 1, speed = rate, turn = rate, worst = 0;
    for (const BodyState& s : a) {
        length = max(length, Real(s.x.norm()));
        speed = max(speed, Real(s.v.norm())), turn = max(turn, Real(s.omega.norm()));
    }
    for (std::size_t i = 0; i < a.size(); ++i)
        for (const Real& ratio :
             {Real((a[i].x - b[i].x).norm() / length), Real((a[i].R - b[i].R).norm()),
              Real((a[i].v - b[i].v).norm() / speed), Real((a[i].omega - b[i].omega).norm() / turn)})
            worst = max(worst, ratio);
    return worst;
}

}  // namespace

Objection equivariance_objection(const Method& entry) {
    const RigidMotion motion;
    // Quad is slow: without a memory the steps after the second one are as the second.
    const int steps = KREISEL_QUAD && !entry.description.keeps_memory ? 2 : 5;
    const Objection found =
        first_objection(entry, [&](const models::Named& named, const std::string& formulation) -> Objection {
            // The fast top rotates by 0.3 rad within a step.
            Trip here(named.model, formulation, entry), there(motion(named.model), formulation, entry);
            for (Trip* trip : {&here, &there})
                if (trip->run(Real(steps) / 512, steps) != Status::ok) return "a run fails";
            std::vector<BodyState> moved = here.bodies();
            for (BodyState& state : moved) state = motion(state);
            // Where velocities follow from positions alone, they have the round-off of places over h, of which the
            // iteration may leave some thousand units in either run (Newton::solve).
            const bool quotients = entry.description.meets_positions && !entry.description.meets_velocities;
            const Real difference = relative_difference(moved, there.bodies(), quotients ? 512 : 1);
            return difference <= (quotients ? 20000 : 1000) * epsilon
                       ? ""
                       : "differs by " + to_text(difference) + " where space is moved";
        });
    if (entry.description.equivariant) return found;
    return found.empty() ? "is equivariant, and denies it" : "";
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
