// SPDX-License-Identifier: BSD-3-Clause
//
// Implicit methods beside stiff springs.
#include "tests/methods/implicit/for_each.hpp"

namespace implicit_stiff_springs {

using namespace kreisel;
using namespace models;
using namespace stepping;
using namespace linkages;

namespace {

Model with_stiff_springs(Model model, const Real& stiffness, const Real& damping) {
    for (int i = 0; i < static_cast<int>(model.bodies.size()); ++i) {
        Spring spring{.first = ground, .second = i, .r_first = Vec3(1, 2, 3)};
        spring.stiffness = stiffness, spring.damping = damping;
        const BodyState& start = model.bodies[static_cast<std::size_t>(i)].start;
        spring.length = (start.x - spring.r_first).norm();
        model.springs.push_back(spring);
    }
    return model;
}

/// With rho = 0.9 the index-3 form is too weakly damped for this chain, with springs or without: what velocities are
/// off their constraints grows twentyfold in six steps of 1/100 s.
OptionValues damping_options(const Method& entry) {
    OptionValues options = default_options(entry.description.options);
    const bool positions_alone = entry.description.reports_multipliers && !entry.description.meets_velocities;
    if (positions_alone && options.count("rho") > 0) options["rho"] = 0.5;
    return options;
}

/// Of an undamped spring: RATTLie and Lobatto pairs have forces at the ends of a step, and are unstable from some h^2
/// k/m on (4, with two stages), Adams-Moulton methods of order 3 and more at any.
bool is_stable_for_small_steps_alone(const Method& entry) {
    const std::string& name = entry.description.name;
    return entry.description.claims(Property::symplectic) || name.starts_with("rkmk/lobatto3ab") ||
           name.starts_with("multistep/adams_moulton");
}

}  // namespace

TEST_CASE("implicit methods handle stiff springs and dampers", "[methods]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    const Real h = Real(1) / 100;
    for_each_implicit([&](const Method& entry) {
        for (const Real& stiffness : {Real(100), Real(10000)})
            for (const Real& damping : {Real(0), Real(stiffness / 100)}) {
                INFO("stiffness " << stiffness << ", damping " << damping);
                for (const Model& model : {standard("double_pendulum"), linked(12, {{ground, 0},
                                                                                    {0, 1},
                                                                                    {1, 2},
                                                                                    {2, 3},
                                                                                    {3, 4},
                                                                                    {4, 5},
                                                                                    {5, 6},
                                                                                    {6, 7},
                                                                                    {7, 8},
                                                                                    {8, 9},
                                                                                    {9, 10},
                                                                                    {10, 11}})}) {
                    const Model sprung = with_stiff_springs(model, stiffness, damping);
                    if (!runs_on(entry, sprung, "SO3xR3")) continue;
                    Trip trip(sprung, "SO3xR3", entry);
                    REQUIRE(trip.integrator->start(0, trip.y.data()) == Status::ok);
                    for (int i = 0; i < 20; ++i) REQUIRE(trip.integrator->step(i * h, h, trip.y.data()) == Status::ok);
                }
            }
    });
}

TEST_CASE("fast motions of stiff springs that nothing damps are solved, or are newton_failed", "[methods]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    // From steps of h^2 k/m = 10 on nothing near the last accelerations is a solution.
    const Real h = Real(1) / 100;
    const Model chain = linked(
        12, {{ground, 0}, {0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 7}, {7, 8}, {8, 9}, {9, 10}, {10, 11}});
    for_each_implicit([&](const Method& entry) {
        if (is_stable_for_small_steps_alone(entry)) return;
        for (const int stiffness : {10000, 100000, 1000000}) {
            INFO("stiffness " << stiffness);
            const bool solvable = stiffness < 1000000;
            Trip trip(with_stiff_springs(chain, stiffness, 0), "SO3xR3", entry, damping_options(entry));
            Status status = trip.integrator->start(0, trip.y.data());
            const int steps = solvable ? 60 : 3;
            for (int i = 0; i < steps && status == Status::ok; ++i)
                status = trip.integrator->step(i * h, h, trip.y.data());
            INFO(name(status));
            CHECK((status == Status::ok || (!solvable && status == Status::newton_failed)));
        }
    });
}

TEST_CASE("beside a stiff spring steps with symmetric projection end on the constraints", "[methods]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    // Forces have a round-off a million times that of the motion, and multipliers follow what is made of it.
    const Real h = Real(1) / 128;
    Trip trip(with_stiff_springs(standard("forced_heavy_top"), Real(10000000000), 0), "SO3xR3",
              method("symmetric_projection/midpoint"));
    for (int i = 0; i < 10; ++i) {
        REQUIRE(trip.integrator->step(h * i, h, trip.y.data()) == Status::ok);
        CHECK(trip.position_defect(h * (i + 1)) <= 1000 * epsilon);
        CHECK(trip.velocity_defect(h * (i + 1)) <= 10000 * epsilon);
    }
}

}  // namespace implicit_stiff_springs
