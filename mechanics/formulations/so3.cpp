// SPDX-License-Identifier: BSD-3-Clause
//
// SO3: bodies that each turn about a fixed point, q = R in SO(3), v = omega. Their joints are removed.
#include "mechanics/formulation.hpp"
#include "mechanics/formulations/pivoted_bodies.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

bool rests_unloaded(const Model& model, int index) {
    if (model.any([&](const auto& force) { return force.touches(index) && force.may_push(index); })) return false;
    return model.bodies[static_cast<std::size_t>(index)].start.v.isZero(0) && model.gravity.g.isZero(0);
}

std::string why_not_pivoted(const Model& model) {
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const Body& body = model.bodies[i];
        const auto joints = joints_of(model, static_cast<int>(i));
        if (joints.empty() && !rests_unloaded(model, static_cast<int>(i)))
            return "body \"" + body.name + "\" has no fixed point: no spherical joint to the ground holds it";
        if (joints.size() > 1) return "body \"" + body.name + "\" has more than one joint, so SO3 cannot remove them";
        if (joints.size() == 1 && joints[0]->first != ground && joints[0]->second != ground)
            return "body \"" + body.name + "\" is joined to a moving body, so no point of it is fixed";
        if (joints.size() == 1 && !joints[0]->type->is_ball())
            return "body \"" + body.name + "\" hangs on a " + joints[0]->type.name() +
                   " joint: SO3 takes spherical ones only";
    }
    return "";
}

std::unique_ptr<System> make_pivoted(const Model& model) { return std::make_unique<PivotedBodies>(model); }

}  // namespace

KREISEL_FORMULATION({.name = "SO3",
                     .summary = "bodies that turn about a fixed point: q = R, v = omega; no constraint is left",
                     .place = 4,
                     .why_not = why_not_pivoted,
                     .make = make_pivoted});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
