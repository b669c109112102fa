// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/model/pivots.hpp"

#include <Eigen/LU>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Those that join a body to another or to the ground.
std::vector<const Joint*> joints_of(const Model& model, int body) {
    std::vector<const Joint*> joints;
    for (const Joint& joint : model.joints)
        if (joint.first == body || joint.second == body) joints.push_back(&joint);
    return joints;
}

bool rests_unloaded(const Model& model, int index) {
    if (model.any([&](const auto& force) { return force.touches(index) && force.may_push(index); })) return false;
    return model.bodies[static_cast<std::size_t>(index)].start.v.isZero(0) && model.gravity.g.isZero(0);
}

}  // namespace

std::vector<Pivoted> pivoted_bodies(const Model& model) {
    std::vector<Pivoted> all;
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const Body& body = model.bodies[i];
        const auto joints = joints_of(model, static_cast<int>(i));
        Vec3 lever = Vec3::Zero(), pivot = body.start.x;
        if (!joints.empty()) {
            const Joint& joint = *joints[0];
            lever = -(joint.first == ground ? joint.r_second : joint.r_first);
            pivot = joint.first == ground ? joint.r_first : joint.r_second;
        }
        const Mat3 J_O = inertia_about(body, lever);
        all.push_back({body.mass, J_O, J_O.inverse(), pivot, lever});
    }
    return all;
}

std::string why_not_pivoted(const Model& model, const std::string& formulation) {
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const std::string body = "body \"" + model.bodies[i].name + "\"";
        const auto joints = joints_of(model, static_cast<int>(i));
        if (joints.empty() && !rests_unloaded(model, static_cast<int>(i)))
            return body + " has no fixed point: no spherical joint to the ground holds it";
        if (joints.size() > 1) return body + " has more than one joint, so " + formulation + " cannot remove them";
        if (joints.size() == 1 && joints[0]->first != ground && joints[0]->second != ground)
            return body + " is joined to a moving body, so no point of it is fixed";
        if (joints.size() == 1 && !joints[0]->type->is_ball())
            return body + " hangs on a " + joints[0]->type.name() + " joint: " + formulation +
                   " takes spherical ones only";
    }
    return "";
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
