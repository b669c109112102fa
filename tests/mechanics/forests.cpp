// SPDX-License-Identifier: BSD-3-Clause
//
// The recursion over forests of spherical joints gives the accelerations and multipliers of the general path, for
// branched trees, free and hung, with bodies and joints in any order.
#include <numeric>
#include <random>

#include "mechanics/solve/forest.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

/// Bodies hung on a random earlier one, on the ground or nowhere, each joint in either direction; then shuffled.
Model random_forest(unsigned seed, int bodies) {
    std::mt19937 engine(seed);
    const auto below = [&](int n) { return static_cast<int>(engine() % static_cast<unsigned>(n)); };
    std::vector<int> label(static_cast<std::size_t>(bodies));
    std::iota(label.begin(), label.end(), 0);
    std::shuffle(label.begin(), label.end(), engine);
    Model model = bodies_in_a_row(bodies);
    for (int i = 0; i < bodies; ++i) {
        const int kind = below(5), body = label[static_cast<std::size_t>(i)];
        if (kind == 0) continue;  // a free body, or the root of a free tree
        const int other = kind == 1 || i == 0 ? ground : label[static_cast<std::size_t>(below(i))];
        const Vec3 point =
            model.bodies[static_cast<std::size_t>(body)].start.x + Vec3(below(5), below(5) - 2, below(3)) / 4;
        if (below(2) == 0)
            model.join(other, body, point);
        else
            model.join(body, other, point);
    }
    std::shuffle(model.joints.begin(), model.joints.end(), engine);
    complete_velocities(model, std::vector<bool>(model.bodies.size(), false));
    for (Body& body : model.bodies)
        body.start.omega += Vec3(1, -2, 1) / 3;  // the rows need not hold at the velocity level
    model.gravity.g = Vec3(1, -2, -9);
    if (seed % 2 == 0) {
        model.loads = {{0, Load::Axes::space, Vec3(3, -1, 2), Vec3(1, 0, -1), 0, 0, Vec3(1, 2, -1) / 4}};
        model.springs = {{ground, bodies - 1, Vec3(9, 1, 0), Vec3(1, 0, 2) / 4, 20, 0, Real(1) / 2}};
    }
    return model;
}

struct Solved {
    VecX a, lambda;
};

Solved accelerations(System& s, const Model& model) {
    const auto y = initial_state(s, model);
    Solved out{VecX(s.velocities()), VecX(s.constraints())};
    REQUIRE(s.accelerations(0, y.data(), s.v(y.data()), out.a.data(), out.lambda.data()) == Status::ok);
    return out;
}

/// For a right-hand side without any structure.
Solved solution(System& s, const Model& model) {
    const auto y = initial_state(s, model);
    Solved out{VecX(s.velocities()), VecX(s.constraints())};
    VecX f(s.velocities()), c(s.constraints());
    for (Eigen::Index i = 0; i < f.size(); ++i) f[i] = Real((7 * i) % 11) - 5;
    for (Eigen::Index i = 0; i < c.size(); ++i) c[i] = Real((5 * i) % 7) - 3;
    REQUIRE(s.solve_kkt(0, y.data(), f.data(), c.data(), out.a.data(), out.lambda.data()) == Status::ok);
    return out;
}

void check_equal(const Solved& a, const Solved& b, const Real& condition) {
    const Real tolerance = (4000 + 10 * condition * condition) * epsilon;
    CHECK((a.a - b.a).norm() <= tolerance * (1 + b.a.norm()));
    CHECK((a.lambda - b.lambda).norm() <= tolerance * (1 + b.lambda.norm()));
}

void compare(const Model& model, const std::string& formulation) {
    const auto general = general_system(model, formulation), recursion = make_system(model, formulation);
    const Real condition = general->constraint_rank().condition.value_or(1);
    check_equal(solution(*recursion, model), solution(*general, model), condition);
    check_equal(accelerations(*recursion, model), accelerations(*general, model), condition);
    check_equal(solution(*recursion, model), solution(*general, model), condition);  // no state is left from before
}

}  // namespace

TEST_CASE("the recursion over a forest agrees with the general path", "[forest]") {
    std::size_t free_trees = 0, branched = 0;
    for (unsigned seed = 0; seed < 30; ++seed) {
        const Model model = random_forest(seed, 2 + static_cast<int>(seed % 9));
        INFO("seed " << seed);
        REQUIRE(takes_recursion(model));
        for (const char* formulation : {"SO3xR3", "SE3", "S3xR3"}) compare(model, formulation);
        std::vector<int> children(model.bodies.size(), 0);
        const auto all = branches(model);
        for (const Branch& branch : all) {
            if (branch.parent < 0) continue;
            const Branch& parent = all[static_cast<std::size_t>(branch.parent)];
            if (++children[static_cast<std::size_t>(branch.parent)] == 2) ++branched;
            if (parent.parent < 0 && parent.joint < 0) ++free_trees;
        }
    }
    CHECK(branched >= 10);
    CHECK(free_trees >= 10);
}

TEST_CASE("branches hold every body once, parents first, with the joint between the two", "[forest]") {
    for (unsigned seed = 0; seed < 10; ++seed) {
        const Model model = random_forest(seed, 12);
        const auto all = branches(model);
        REQUIRE(all.size() == model.bodies.size());
        std::vector<bool> seen(all.size(), false);
        for (std::size_t i = 0; i < all.size(); ++i) {
            REQUIRE(!seen[static_cast<std::size_t>(all[i].body)]);
            seen[static_cast<std::size_t>(all[i].body)] = true;
            CHECK(all[i].parent < static_cast<int>(i));
            if (all[i].joint < 0) continue;
            const Joint& joint = model.joints[static_cast<std::size_t>(all[i].joint)];
            const int parent = all[i].parent < 0 ? ground : all[static_cast<std::size_t>(all[i].parent)].body;
            CHECK(((joint.first == parent && joint.second == all[i].body) ||
                   (joint.second == parent && joint.first == all[i].body)));
        }
    }
}

TEST_CASE("loops and other joints are not a forest of spherical joints", "[forest]") {
    Model model = bodies_in_a_row(2);
    model.join(ground, 0, Vec3::Zero());
    model.join(0, 1, Vec3(1, 1, 0));
    CHECK(takes_recursion(model));
    Model loop = model;
    loop.join(1, ground, Vec3(2, 2, 1));
    CHECK_FALSE(is_forest(loop));
    CHECK_FALSE(takes_recursion(loop));
    model.joints[1].type = "revolute";
    CHECK(is_forest(model));
    CHECK_FALSE(takes_recursion(model));
}
