// SPDX-License-Identifier: BSD-3-Clause
#include "tests/metamorphic/descriptions/transformation.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "lie/so3.hpp"
#include "mechanics/formulation.hpp"
#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

namespace {

using Made = std::optional<Transformed>;

Transformed with(const Model& model, const Change& change) {
    return {change(model), change.time, change.length, false,
            [change, model](const Outcome& outcome) { return change.back(outcome, model); }};
}

Real power_of_two(int k) {
    return k < 0 ? Real(1) / power_of_two(-k) : k == 0 ? Real(1) : Real(2) * power_of_two(k - 1);
}

/// Which of redundant rows are kept is decided by pivots that are equal up to round-off; off the constraints the choice
/// matters.
Agreement unless_redundant(const Model& model, Agreement agreement) {
    return has_redundant_rows(model) ? Agreement::truncation : agreement;
}

/// Partitioned coordinates are components along axes of space and bodies, and of two that are as good the first.
bool prefers_coordinates(const Combination& combination) { return combination.projection == "coordinate_partitioning"; }

Agreement of_directions(const Model& model, const Combination& combination) {
    return prefers_coordinates(combination) ? Agreement::truncation : unless_redundant(model, Agreement::round_off);
}

/// Stages of the baselines are not rotations; a solve at them depends on its starting point.
Agreement of_orders(const Model& model, const Combination& combination) {
    return combination.method.starts_with("baseline/") || prefers_coordinates(combination)
               ? Agreement::truncation
               : unless_redundant(model, Agreement::round_off);
}

auto always(Agreement agreement) {
    return [agreement](const Model&, const Combination&) { return agreement; };
}

bool is_implicit(const Combination& combination) { return method(combination.method).description.is_implicit(); }

/// If an unknown changes sign, its difference quotient does not.
Agreement of_mirrors(const Model& model, const Combination& combination) {
    return unless_redundant(model, is_implicit(combination) ? Agreement::round_off : Agreement::bits);
}

void add_units(std::vector<Transformation>& all) {
    for (const int k : {-20, -7, 3, 20}) {
        const Real factor = power_of_two(k);
        const std::string by = " times 2^" + std::to_string(k);
        all.push_back({"lengths" + by, [=](const Model& m) -> Made { return with(m, {.length = factor}); },
                       always(Agreement::bits)});
        all.push_back({"masses" + by, [=](const Model& m) -> Made { return with(m, {.mass = factor}); },
                       always(Agreement::bits)});
        all.push_back(
            {"time" + by, [=](const Model& m) -> Made { return with(m, {.time = factor}); }, always(Agreement::bits)});
    }
}

Made reflected(const Model& model, Eigen::Index normal) {
    Change change;
    change.space(normal, normal) = -1;
    change.axes.assign(model.bodies.size(), change.space);
    return with(model, change);
}

/// Of one length, along no axis.
Made moved(const Model& model, const Real& distance) { return with(model, {.shift = distance / 7 * Vec3(6, -2, 3)}); }

Made turned(const Model& model) {
    return with(model, {.space = SO3::exp(Vec3(Real(1) / 3, Real(-6) / 5, Real(3) / 4)),
                        .axes = std::vector<Mat3>(model.bodies.size(), Mat3::Identity())});
}

Made in_other_axes(const Model& model) {
    Change change;
    for (std::size_t i = 0; i < model.bodies.size(); ++i)
        change.axes.push_back(SO3::exp(Vec3(Real(-2) / 3, Real(1) / 5, Real(static_cast<int>(i) + 1) / 2)));
    return with(model, change);
}

/// In reverse order.
std::vector<int> backwards(std::size_t count) {
    std::vector<int> order(count);
    std::iota(order.rbegin(), order.rend(), 0);
    return order;
}

Made reordered(const Model& model) {
    if (model.bodies.size() < 2 && model.joints.size() < 2) return {};
    return with(model, {.bodies = backwards(model.bodies.size()), .joints = backwards(model.joints.size())});
}

bool reversible(const Joint& joint) { return joint.type != "rolling" && joint.type != "rack"; }
/// Those whose rows only change their sign.
bool symmetric(const Joint& joint) { return joint.type == "spherical" || joint.type == "distance"; }

template <class Choice>
Made reversed(const Model& model, Choice choice) {
    Change change;
    for (const Joint& joint : model.joints) change.reversed.push_back(choice(joint));
    if (std::find(change.reversed.begin(), change.reversed.end(), true) == change.reversed.end()) return {};
    return with(model, change);
}

/// Coordinates of the second kind are angles about the axes of a body.
bool prefers_axes(const Combination& combination) {
    if (prefers_coordinates(combination)) return true;
    const auto coordinates = combination.options.find("coordinates");
    return coordinates != combination.options.end() && coordinates->second == OptionValue("second_kind");
}

Agreement of_axes(const Model& model, const Combination& combination) {
    return prefers_axes(combination) ? Agreement::truncation : unless_redundant(model, Agreement::round_off);
}

/// On SE3 two bodies moving rigidly together keep their relative pose for any step; on other groups the joint between
/// them is satisfied up to the order of the method.
Agreement of_splits(const Model& model, const Combination& combination) {
    const bool kept = combination.formulation == "SE3" && !has_redundant_rows(model) && !prefers_axes(combination);
    return kept ? Agreement::round_off : Agreement::truncation;
}

void add_descriptions(std::vector<Transformation>& all) {
    for (const Eigen::Index k : {0, 1, 2})
        all.push_back(
            {std::string("reflected in ") + "xyz"[k], [k](const Model& m) { return reflected(m, k); }, of_mirrors});
    all.push_back(
        {"renamed", [](const Model& m) -> Made { return with(m, {.prefix = "a_"}); }, always(Agreement::bits)});
    for (const int kilometres : {1, 1000})
        all.push_back({"moved by " + std::to_string(kilometres) + " km",
                       [=](const Model& m) { return moved(m, Real(1000) * kilometres); },
                       always(Agreement::round_off)});
    all.push_back({"turned", turned, of_directions});
    all.push_back({"bodies in other axes", in_other_axes, of_axes});
    all.push_back({"zero of torsion moved", moved_zero, always(Agreement::round_off)});
    all.push_back({"reordered", reordered, of_orders});
    all.push_back({"symmetric joints reversed", [](const Model& m) { return reversed(m, symmetric); }, of_orders});
    all.push_back(
        {"all joints reversed", [](const Model& m) { return reversed(m, reversible); }, always(Agreement::truncation)});
    all.push_back({"a body split", split, of_splits});
}

Made restarted(const Model& model) {
    Transformed same = with(model, {});
    same.restart = true;
    return same;
}

}  // namespace

const char* to_text(Agreement agreement) {
    switch (agreement) {
        case Agreement::bits:
            return "bits";
        case Agreement::round_off:
            return "round-off";
        case Agreement::truncation:
            return "truncation";
    }
    return "";
}

const std::vector<Transformation>& transformations() {
    static const std::vector<Transformation> all = [] {
        std::vector<Transformation> list;
        add_units(list);
        add_descriptions(list);
        // A method without memory restarts in every step.
        list.push_back({"restarted", restarted, [](const Model&, const Combination& c) {
                            return method(c.method).description.meets_constraints() ? Agreement::truncation
                                                                                    : Agreement::round_off;
                        }});
        return list;
    }();
    return all;
}

const Transformation& transformation(const std::string& name) {
    for (const Transformation& entry : transformations())
        if (entry.name == name) return entry;
    throw std::out_of_range("no transformation \"" + name + "\"");
}

bool has_redundant_rows(const Model& model) {
    const ConstraintRank rank = make_system(model, "SO3xR3")->constraint_rank();
    return rank.rank < rank.rows;
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
