// SPDX-License-Identifier: BSD-3-Clause
//
// Every force has what it declares (mechanics/forces/forces.hpp): action and reaction, a centre, an energy; and every
// name that configs may write makes one.
#include <map>
#include <set>
#include <string>
#include <typeindex>

#include "lie/so3.hpp"
#include "mechanics/forces/entry.hpp"
#include "mechanics/parts/force_type.hpp"
#include "mechanics/parts/joint_type.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

const Real round_off_of_forces = 10000 * epsilon;

/// Where the ground and two bodies are a time s after some moment.
Motion moved_for(const Real& s, int body) {
    static const Motion first{Vec3(1, 2, -1), SO3::exp(Vec3(1, -2, 1) / 3), Vec3(2, 0, 1), Vec3(1, 3, -2)};
    static const Motion second{Vec3(3, -1, 1), SO3::exp(Vec3(-1, 1, 2) / 4), Vec3(-1, 2, 1), Vec3(-2, 1, 1)};
    if (body == ground) return {};
    const Motion& now = body == 0 ? first : second;
    return {now.x + s * (now.R * now.V), now.R * SO3::exp(s * now.omega), now.V, now.omega};
}

Motion at_once(int body) { return moved_for(0, body); }

/// One force, from a body or the ground to the second body.
Forces made_by(const ForceReader& type, int first, const Real& damping) {
    ForceEntry entry{.first = first, .second = 1, .r_first = Vec3(1, 0, 2) / 3, .r_second = Vec3(0, 1, -1) / 2};
    entry.distance = 1, entry.rest = Real(1) / 2;
    entry.axes_first = axes_about(Vec3(1, 1, 3)), entry.axes_second = axes_about(Vec3(2, -1, 1));
    entry.stiffness = 5, entry.damping = damping;
    entry.value = Vec3(3, -1, 2), entry.point = Vec3(1, 2, -1) / 4;
    entry.amplitude = Real(1) / 4, entry.frequency = 3;
    entry.coefficients = {4, -1, Real(1) / 2};
    entry.stiffnesses = {Vec3(5, 2, 3), Vec3(1, 4, 2)};
    entry.dampings = {damping * Vec3(1, 2, 1), damping * Vec3(1, 1, 3)};
    entry.attraction = 6, entry.mass_first = 2, entry.mass_second = 3;
    Forces forces;
    type.read(entry, forces);
    return forces;
}

/// Of everything a force exerts, in space axes; the moment is about a point.
struct Sum {
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    Real power = 0;
};

template <class Force>
Sum sum_about(const Force& force, const Vec3& point) {
    Sum sum;
    force.act(
        0, at_once, [](const Turn& turn) { return turn.principal; },
        [&](int body, const Wrench& wrench) {
            const Motion on = at_once(body);
            sum.force += on.R * wrench.force;
            sum.moment += on.R * wrench.torque + (on.x - point).cross(on.R * wrench.force);
            sum.power += wrench.force.dot(on.V) + wrench.torque.dot(on.omega);
        });
    return sum;
}

template <class Force>
Real energy_after(const Real& s, const Force& force) {
    const auto motion = [&](int body) { return moved_for(s, body); };
    return force.energy(motion, [&]() -> Real {
        if constexpr (requires { turn(force, motion(0), motion(1)); })
            return turn(force, motion(force.first), motion(force.second)).principal;
        else
            return 0;
    });
}

template <class Force>
void check_bodies(const Force& force) {
    int pushed = 0;
    force.act(
        0, at_once, [](const Turn& turn) { return turn.principal; },
        [&](int body, const Wrench& wrench) {
            ++pushed;
            CHECK(body != ground);
            CHECK(force.touches(body));
            if (!force.may_push(body)) CHECK(wrench.force.norm() == 0);
            if (const Vec3* centre = force.centre_on(body))
                CHECK((wrench.torque - centre->cross(wrench.force)).norm() <= round_off_of_forces);
        });
    CHECK(pushed == int(force.touches(0)) + int(force.touches(1)));
}

template <class Force>
void check_balances(const Force& force) {
    if (force.is_internal()) {
        CHECK_FALSE(force.touches(ground));
        const Sum sum = sum_about(force, Vec3(3, 1, 2));
        CHECK(sum.force.norm() + sum.moment.norm() <= round_off_of_forces);
    } else if (const Vec3* centre = force.touches(ground) ? force.centre_on(ground) : nullptr) {
        CHECK(sum_about(force, *centre).moment.norm() <= round_off_of_forces);
    }
    if (!force.is_conservative()) return;
    const Real h = pow(epsilon, Real(1) / 3), rate = (energy_after(h, force) - energy_after(-h, force)) / (2 * h);
    CHECK(abs(sum_about(force, Vec3::Zero()).power + rate) <= 10000 * pow(epsilon, Real(2) / 3) * (1 + abs(rate)));
}

}  // namespace

TEST_CASE("every force has what it declares", "[forces]") {
    for (const ForceReader& type : Registered<ForceReader>::all())
        for (const int first : {ground, 0})
            for (const int damping : {0, 3}) {
                if (type.name == "gravitation" && first == ground) continue;  // the ground has no mass
                CAPTURE(type.name, first, damping);
                const Forces forces = made_by(type, first, damping);
                REQUIRE(has_forces(forces));
                forces.each([](const auto& force, std::size_t) { check_bodies(force), check_balances(force); });
            }
}

TEST_CASE("every name of a force in configs makes one, and only those do", "[forces]") {
    std::set<std::string> keys, readers;
    for (const ForceKind& kind : force_kinds()) keys.insert(kind.name);
    for (const ForceReader& reader : Registered<ForceReader>::all()) readers.insert(reader.name);
    CHECK(keys == readers);
}

TEST_CASE("results tell forces between bodies by types of their own, which no joint has", "[forces]") {
    std::map<std::string, std::type_index> laws;
    for (const ForceReader& reader : Registered<ForceReader>::all())
        made_by(reader, 0, 3).each([&](const auto& force, std::size_t) {
            if constexpr (requires { force.first; }) {
                const std::type_index law(typeid(force));
                CAPTURE(force.type);
                CHECK(find_joint_kind(force.type) == nullptr);
                CHECK(laws.emplace(force.type, law).first->second == law);
            }
        });
    CHECK_FALSE(laws.empty());
}
