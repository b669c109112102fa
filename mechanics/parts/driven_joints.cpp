// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/driven_joints.hpp"

#include <algorithm>
#include <stdexcept>

namespace kreisel {

namespace {

std::string name_of(const std::string& joint, const Drive& drive) {
    return joint + " with driven " + (drive.turn ? "turn" : "") + (drive.turn && drive.shift ? " and " : "") +
           (drive.shift ? "shift" : "");
}

/// The row on points goes before those that compare directions.
JointKind with_rows(const JointKind& kind, const Drive& drive) {
    JointRecipe recipe = kind;
    recipe.name = name_of(kind.name, drive);
    const auto directions = std::find_if(recipe.rows.begin(), recipe.rows.end(),
                                         [](const JointRow& row) { return row.primitive == Primitive::orthogonal; });
    if (drive.shift) {
        recipe.rows.insert(directions, shift());
        std::erase(recipe.free, FreeMotion::slide_along_axis);
    }
    if (drive.turn) {
        recipe.rows.push_back(turn());
        std::erase(recipe.free, FreeMotion::turn_about_axis);
    }
    JointKind driven(recipe);
    driven.element = kind.element;
    return driven;
}

std::vector<JointKind> all_driven() {
    std::vector<JointKind> all;
    for (const JointKind& kind : joint_kinds()) {
        const Drive most = drivable(kind);
        if (most.turn) all.push_back(with_rows(kind, {.turn = true}));
        if (most.shift) all.push_back(with_rows(kind, {.shift = true}));
        if (most.turn && most.shift) all.push_back(with_rows(kind, most));
    }
    return all;
}

}  // namespace

Drive drivable(const JointRecipe& recipe) {
    const auto has = [&](FreeMotion motion) {
        return std::find(recipe.free.begin(), recipe.free.end(), motion) != recipe.free.end();
    };
    return {has(FreeMotion::turn_about_axis), has(FreeMotion::slide_along_axis)};
}

const std::vector<JointKind>& driven_kinds() {
    static const std::vector<JointKind> all = all_driven();
    return all;
}

JointType driven(JointType type, const Drive& drive) {
    if (!drive.turn && !drive.shift) return type;
    const std::string name = name_of(type.name(), drive);
    for (const JointKind& kind : driven_kinds())
        if (kind.name == name) return JointType(kind);
    throw std::invalid_argument("no joint \"" + name + "\"");
}

}  // namespace kreisel
