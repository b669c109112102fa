// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/joint_type.hpp"

#include <algorithm>
#include <stdexcept>

#include "mechanics/parts/driven_joints.hpp"

namespace kreisel {

namespace {

struct RowCounts {
    int all, position;
    bool direction;
};

RowCounts counts_of(Primitive primitive) {
    switch (primitive) {
        case Primitive::coincidence:
            return {3, 3, false};
        case Primitive::along:
        case Primitive::distance:
        case Primitive::shift:
            return {1, 1, false};
        case Primitive::orthogonal:
        case Primitive::turn:
        case Primitive::helix:
        case Primitive::rack:
        case Primitive::mesh:
            return {1, 1, true};
        case Primitive::contact:
            return {3, 1, false};
    }
    return {};
}

bool compares_directions(const JointRow& row) { return counts_of(row.primitive).direction; }

bool needs(const JointRecipe& recipe, Primitive primitive) {
    return std::any_of(recipe.rows.begin(), recipe.rows.end(),
                       [&](const JointRow& row) { return row.primitive == primitive; });
}

ElementType element_of(const JointRecipe& recipe) {
    using Kind = ValueKind;
    ElementType type = {recipe.name, recipe.summary, {{"between", Kind::names, true}}};
    const auto one_or_each = [&](const char* one, const char* each) {
        type.keys.push_back({one, Kind::vector, false});
        type.keys.push_back({each, Kind::vectors, false});
        type.alternatives.push_back({one, each, true});
    };
    const bool rod = needs(recipe, Primitive::distance), disk = needs(recipe, Primitive::contact);
    const bool gear = needs(recipe, Primitive::mesh);
    if (rod || disk || gear || needs(recipe, Primitive::rack))
        type.keys.push_back({"points", Kind::vectors, true});
    else
        one_or_each("point", "points");
    if (recipe.axes == JointAxes::common)
        one_or_each("axis", "axes");
    else if (recipe.axes != JointAxes::none)
        type.keys.push_back({"axes", Kind::vectors, true});
    if (rod)
        type.keys.insert(type.keys.end(), {{"length", Kind::positive, false},
                                           {"amplitude", Kind::number, false},
                                           {"frequency", Kind::number, false}});
    if (disk) type.keys.push_back({"radius", Kind::positive, true});
    if (gear) type.keys.push_back({"teeth", Kind::teeth, true});
    if (needs(recipe, Primitive::helix)) type.keys.push_back({"lead", Kind::number, true});
    const Drive drive = drivable(recipe);
    if (drive.turn) type.keys.push_back({"turn", Kind::motion, false});
    if (drive.shift) type.keys.push_back({"shift", Kind::motion, false});
    type.keys.push_back({"name", Kind::label, false});
    return type;
}

const std::vector<JointKind>& checked(const std::vector<JointKind>& kinds) {
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        if (const std::string fault = fault_of(kinds[i]); !fault.empty())
            throw std::logic_error("joint \"" + kinds[i].name + "\": " + fault);
        if (i > 0 && kinds[i].name == kinds[i - 1].name)
            throw std::logic_error("two joints are called \"" + kinds[i].name + "\"");
    }
    return kinds;
}

}  // namespace

int rows_in(Primitive primitive) { return counts_of(primitive).all; }

int count_of(FreeMotion motion) {
    switch (motion) {
        case FreeMotion::turn_about_axis:
        case FreeMotion::turn_about_normal:
        case FreeMotion::slide_along_axis:
        case FreeMotion::screw:
            return 1;
        case FreeMotion::turn_about_two:
        case FreeMotion::slide_across_axis:
        case FreeMotion::swing:
            return 2;
        case FreeMotion::turn_about_point:
        case FreeMotion::roll:
            return 3;
        case FreeMotion::mesh:
            return 5;
    }
    return 0;
}

std::string fault_of(const JointRecipe& recipe) {
    const std::vector<JointRow>& rows = recipe.rows;
    int count = 0, free = 0;
    for (const JointRow& row : rows) {
        if (row.i < 0 || row.i > 2 || row.k < 0 || row.k > 2) return "axes are numbered 1, 2, 3";
        count += counts_of(row.primitive).all;
    }
    for (const FreeMotion motion : recipe.free) free += count_of(motion);
    if (count == 0) return "expected at least one row";
    if (count + free != 6)
        return "expected rows and free motions that add up to 6, got " + std::to_string(count) + " and " +
               std::to_string(free);
    const auto directions = std::find_if(rows.begin(), rows.end(), compares_directions);
    if (!std::all_of(directions, rows.end(), compares_directions))
        return "expected the rows on the points before those that compare directions";
    const auto fits = [&](const JointRow& row) {
        return row.primitive == rows[0].primitive ||
               (row.primitive == Primitive::shift && rows[0].primitive == Primitive::along);
    };
    if (!std::all_of(rows.begin(), directions, fits)) return "expected rows on the points of one primitive";
    if (needs(recipe, Primitive::contact) && rows.size() > 1) return "a contact has no other rows beside it";
    if (needs(recipe, Primitive::contact) != (recipe.axes == JointAxes::not_parallel))
        return "a contact, and nothing else, has axes that are not parallel";
    return "";
}

JointKind::JointKind(JointRecipe recipe) : JointRecipe(std::move(recipe)), element(element_of(*this)) {
    for (const JointRow& row : rows) {
        const RowCounts counts = counts_of(row.primitive);
        row_count += counts.all, position_count += counts.position;
        length_count += counts.direction ? 0 : counts.all;
    }
    holds_points = std::all_of(rows.begin(), rows.end(), [](const JointRow& row) {
        return row.primitive == Primitive::coincidence || row.primitive == Primitive::distance;
    });
}

bool JointKind::has(Primitive primitive) const { return needs(*this, primitive); }
int JointKind::row_of(Primitive primitive) const {
    int row = 0;
    for (const JointRow& one : rows) {
        if (one.primitive == primitive) return row;
        row += rows_in(one.primitive);
    }
    return -1;
}
bool JointKind::has(FreeMotion motion) const { return std::find(free.begin(), free.end(), motion) != free.end(); }

JointType::JointType(const std::string& name) : kind_(find_joint_kind(name)) {
    if (kind_) return;
    std::string known;
    for (const std::string& one : joint_names()) known += (known.empty() ? "" : ", ") + one;
    throw std::invalid_argument("no joint \"" + name + "\"; there are " + known);
}

const std::vector<JointKind>& joint_kinds() {
    static const std::vector<JointKind>& all = checked(Registered<JointKind>::all());
    return all;
}

const JointKind* find_joint_kind(const std::string& name) {
    for (const JointKind& kind : joint_kinds())
        if (kind.name == name) return &kind;
    return nullptr;
}

std::vector<std::string> joint_names() {
    std::vector<std::string> names;
    for (const JointKind& kind : joint_kinds()) names.emplace_back(kind.name);
    return names;
}

std::string joints_that_hold_points() {
    std::vector<std::string> names;
    for (const JointKind& kind : joint_kinds())
        if (kind.holds_points) names.emplace_back(kind.name);
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}

}  // namespace kreisel
