// SPDX-License-Identifier: BSD-3-Clause
//
// Models in Simbody's terms.
#pragma once

#include <algorithm>
#include <span>
#include <stdexcept>

#include "mechanics/model/model.hpp"
#include "tests/peers/simbody/wrapper/simbody.hpp"

namespace outside {

using namespace kreisel;

/// Whether a joint of a type holds a body to the ground.
inline bool on_ground(const Model& model, int body, const char* type) {
    return std::any_of(model.joints.begin(), model.joints.end(), [&](const Joint& joint) {
        return joint.first == ground && joint.second == body && joint.type == type;
    });
}

/// Why a model is not compared with Simbody; empty if it is.
inline std::string why_not(const Model& model) {
    for (const Joint& joint : model.joints) {
        if (joint.type == "rolling") return "rolling joints";
        if (joint.type == "gear" || joint.type == "rack") {
            const char* first = joint.type == "gear" ? "revolute" : "prismatic";
            if (!on_ground(model, joint.first, first) || !on_ground(model, joint.second, "revolute"))
                return "wheels whose line of centres moves";
        }
        if (joint.amplitude != 0) return "driven lengths";
    }
    if (!model.warnings.empty()) return "inertias that no body has";
    if (!model.gravity.is_constant()) return "gravity that depends on time";
    if (!model.torsion_springs.empty()) return "torsion springs";
    if (!model.polynomial_springs.empty()) return "polynomial springs";
    if (!model.dampers.empty() || !model.rotational_dampers.empty()) return "dampers in every direction";
    if (!model.attractions.empty()) return "attractions";
    for (const Load& load : model.loads)
        if (load.axes == Load::Axes::body || load.amplitude != 0) return "loads that change";
    return "";
}

inline std::optional<Law> law_of(const Joint& joint, Primitive row, const Prescribed& motion) {
    if (!joint.type->has(row)) return {};
    Law law{motion.polynomial, {}};
    for (const Sinusoid& one : motion.sinusoids) law.waves.push_back({one.amplitude, one.frequency, one.phase});
    return law;
}

/// Throws std::invalid_argument if why_not is not empty.
inline Mechanism translate(const Model& model) {
    if (const std::string reason = why_not(model); !reason.empty())
        throw std::invalid_argument("not for Simbody: " + reason);
    Mechanism result;
    for (const Body& b : model.bodies) result.bodies.push_back({b.mass, b.J});
    for (const Joint& j : model.joints)
        result.links.push_back({j.first,
                                j.second,
                                j.type->element.name,
                                j.r_first,
                                j.r_second,
                                j.axes_first,
                                j.axes_second,
                                j.length,
                                j.lead,
                                law_of(j, Primitive::turn, j.turn),
                                law_of(j, Primitive::shift, j.shift),
                                {j.teeth[0], j.teeth[1]}});
    for (const Spring& s : model.springs)
        result.springs.push_back({s.first, s.second, s.r_first, s.r_second, s.stiffness, s.damping, s.length});
    for (const Bushing& b : model.bushings)
        result.bushings.push_back({b.first, b.second, b.r_first, b.r_second, b.axes_first, b.axes_second,
                                   b.stiffness[0], b.stiffness[1], b.damping[0], b.damping[1]});
    for (const Load& l : model.loads) result.loads.push_back({l.body, l.force, l.torque, l.point});
    result.gravity = model.gravity.g;
    return result;
}

inline std::vector<Pose> translate(std::span<const BodyState> bodies) {
    std::vector<Pose> poses;
    for (const BodyState& b : bodies) poses.push_back({b.x, b.R, b.v, b.omega});
    return poses;
}

inline std::vector<BodyState> translate(const std::vector<Pose>& poses) {
    std::vector<BodyState> bodies;
    for (const Pose& p : poses) bodies.push_back({p.x, p.R, p.v, p.omega});
    return bodies;
}

inline std::vector<BodyState> starts(const Model& model) {
    std::vector<BodyState> bodies;
    for (const Body& body : model.bodies) bodies.push_back(body.start);
    return bodies;
}

}  // namespace outside
