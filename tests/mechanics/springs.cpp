// SPDX-License-Identifier: BSD-3-Clause
//
// Springs and dampers against their balances: action and reaction, power against the rate of the stored energy, and no
// effect at all if two bodies move rigidly together.
#include <functional>

#include "lie/so3.hpp"
#include "mechanics/forces/forces.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

const Motion one{Vec3(1, 2, -1), SO3::exp(Vec3(1, -2, 1) / 3), Vec3(2, 0, 1), Vec3(1, 3, -2)};
const Motion other{Vec3(3, -1, 1), SO3::exp(Vec3(-1, 1, 2) / 4), Vec3(-1, 2, 1), Vec3(-2, 1, 1)};
const Spring spring{0, 1, Vec3(1, 0, 2) / 3, Vec3(0, 1, -1) / 2, 5, 3, Real(1) / 2};
const TorsionSpring torsion{0, 1, axes_about(Vec3(1, 1, 3)), axes_about(Vec3(2, -1, 1)), 5, 3, Real(1) / 4};

Motion after(const Motion& m, const Real& t) {
    return {m.x + t * (m.R * m.V), m.R * SO3::exp(t * m.omega), m.V, m.omega};
}

/// The second body carried along by the first, as if welded to it.
Motion carried_along() {
    const Vec3 omega = one.R * one.omega, velocity = one.R * one.V + omega.cross(other.x - one.x);
    return {other.x, other.R, other.R.transpose() * velocity, other.R.transpose() * omega};
}

Real rate(const std::function<Real(const Real&)>& f) {
    const Real h = pow(epsilon, Real(1) / 3);
    return (f(h) - f(-h)) / (2 * h);
}

Real power(const Wrench& wrench, const Motion& m) { return wrench.force.dot(m.V) + wrench.torque.dot(m.omega); }

Real energy_of(const Spring& element, const Motion& first, const Motion& second) {
    return stored_energy(element, first, second);
}
/// Without full turns.
Real energy_of(const TorsionSpring& element, const Motion& first, const Motion& second) {
    return stored_energy(element, turn(element, first, second).principal);
}
WrenchPair wrenches_of(const Spring& element, const Motion& first, const Motion& second) {
    return exerted(element, first, second);
}
WrenchPair wrenches_of(const TorsionSpring& element, const Motion& first, const Motion& second) {
    const Turn now = turn(element, first, second);
    return exerted(element, now, now.principal, first, second);
}

template <class Element>
Real power_of(const Element& element, const Motion& first, const Motion& second) {
    const WrenchPair pair = wrenches_of(element, first, second);
    return power(pair.first, first) + power(pair.second, second);
}

/// Stiffness k and damping c: -(V' + c s'^2) with the elongation s, for which V = k s^2/2.
template <class Element>
void check_power(Element element) {
    const auto energy = [&](const Real& t) { return energy_of(element, after(one, t), after(other, t)); };
    Element unit = element;
    unit.stiffness = 2;
    const auto elongation = [&](const Real& t) { return sqrt(energy_of(unit, after(one, t), after(other, t))); };
    const Real s_rate = rate(elongation), expected = -rate(energy) - element.damping * s_rate * s_rate;
    REQUIRE(abs(s_rate) > Real(1) / 10);
    CHECK(abs(power_of(element, one, other) - expected) <= 1000 * pow(epsilon, Real(2) / 3) * (1 + abs(expected)));
}

}  // namespace

TEST_CASE("the power of springs and dampers is the loss of their energy and in their dampers", "[forces]") {
    check_power(spring);
    check_power(torsion);
}

TEST_CASE("springs and dampers act and react in one line", "[forces]") {
    const WrenchPair pull = exerted(spring, one, other), twist = wrenches_of(torsion, one, other);
    const auto moment = [](const Wrench& w, const Motion& m) {
        return Vec3(m.R * w.torque + m.x.cross(m.R * w.force));
    };
    CHECK((one.R * pull.first.force + other.R * pull.second.force).norm() <= 100 * epsilon);
    CHECK((moment(pull.first, one) + moment(pull.second, other)).norm() <= 1000 * epsilon);
    CHECK((moment(twist.first, one) + moment(twist.second, other)).norm() <= 1000 * epsilon);
    CHECK(twist.first.force.norm() + twist.second.force.norm() == 0);
}

TEST_CASE("a damper does nothing between bodies that move as one", "[forces]") {
    Spring damper = spring;
    damper.stiffness = 0;
    TorsionSpring brake = torsion;
    brake.stiffness = 0;
    const Motion second = carried_along();
    for (const WrenchPair& pair : {wrenches_of(damper, one, second), wrenches_of(brake, one, second)})
        for (const Wrench& wrench : {pair.first, pair.second})
            CHECK(wrench.force.norm() + wrench.torque.norm() <= 1000 * epsilon);
}
