// SPDX-License-Identifier: BSD-3-Clause
#include "tests/metamorphic/models/named_models.hpp"

#include <algorithm>
#include <stdexcept>

#include "tests/mechanics/models/models.hpp"
#include "tests/metamorphic/models/motion.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

namespace {

/// Two wheels on hinges with torsion springs, which wind them up past half a turn.
Model winding() {
    Model model;
    const Vec3 axis(1, 2, 2);
    for (int i = 0; i < 2; ++i) {
        Body wheel{.name = "wheel" + std::to_string(i), .mass = Real(3) / 2};
        const Mat3 A = axes_about(axis);
        wheel.J = A * Vec3(Real(1) / 2, Real(1) / 2, 1).asDiagonal() * A.transpose();
        wheel.J = (wheel.J + Mat3(wheel.J.transpose())) / 2;
        wheel.start.x = Vec3(i, 1 - i, 2 * i) / 2;
        wheel.start.omega = Real(5 - 2 * i) * axis;
        model.bodies.push_back(wheel);
        model.join(ground, i, wheel.start.x, "revolute", axis);
        model.torsion_springs.push_back({.second = i,
                                         .axes_first = axes_about(axis) * SO3::exp(Real(-5) / 2 * Vec3::UnitZ()),
                                         .axes_second = axes_about(axis),
                                         .stiffness = Real(8) / (i + 1),
                                         .damping = Real(i) / 4,
                                         .angle = Real(7) / 4 * i});
    }
    return model;
}

/// Two hinges on one line, a redundant row for each of five, and a spring.
Model doubly_hinged() {
    Model model = models::hinges_in_line(0, 2);
    model.springs = {{ground, 1, Vec3(2, 0, 1), Vec3(0, 1, 1) / 4, 8, 0, Real(1) / 2}};
    return model;
}

Real step_for(const Model& model) {
    const Real rate = fastest_rate(model);
    Real h = 1;
    if (!(rate > 0)) throw std::logic_error("nothing moves");
    while (h * rate * 20 > 1) h /= 2;
    while (h * rate * 40 < 1) h *= 2;
    return h;
}

}  // namespace

const std::vector<NamedModel>& named_models() {
    static const std::vector<NamedModel> all = [] {
        std::vector<NamedModel> list;
        const auto add = [&](const std::string& name, const Model& model) {
            const auto taken = [&](const NamedModel& other) { return other.name == name; };
            const bool again = std::any_of(list.begin(), list.end(), taken);
            list.push_back({again ? name + " of tests" : name, model, step_for(model)});
        };
        for (const models::Named& named : models::all()) add(named.name, named.model);
        add("winding", winding());
        add("doubly hinged", doubly_hinged());
        return list;
    }();
    return all;
}

const NamedModel& named_model(const std::string& name) {
    for (const NamedModel& entry : named_models())
        if (entry.name == name) return entry;
    throw std::out_of_range("no model \"" + name + "\"");
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
