// SPDX-License-Identifier: BSD-3-Clause
//
// The three ways to solve with C M^{-1} C^T give the same accelerations and multipliers, and the general path gives
// those of the one for spherical joints.
#include "mechanics/solve/forest.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

struct Answer {
    VecX a, lambda;
};

Answer answer(System& s, const Model& model) {
    const auto y = initial_state(s, model);
    Answer answer{VecX(s.velocities()), VecX(s.constraints())};
    REQUIRE(s.accelerations(Real(1) / 4, y.data(), s.v(y.data()), answer.a.data(),
                            answer.lambda.size() > 0 ? answer.lambda.data() : nullptr) == Status::ok);
    return answer;
}

void check_same(const Answer& a, const Answer& b, const Real& condition) {
    const Real tolerance = (4000 + 10 * condition * condition) * epsilon;
    CHECK((a.a - b.a).norm() <= tolerance * (1 + b.a.norm()));
    CHECK((a.lambda - b.lambda).norm() <= tolerance * (1 + b.lambda.norm()));
}

/// Bodies in a square net, every one joined to its neighbours by rods, the corners to the ground: many loops.
Model net(int n) {
    Model model;
    const auto at = [n](int i, int j) { return n * i + j; };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            Body body = asymmetric_body(at(i, j));
            body.start = {Vec3(3 * i, 3 * j, (i * j) % 3), body.start.R, Vec3::Zero(), Vec3::Zero()};
            model.bodies.push_back(body);
        }
    const auto rod = [&](int first, int second, const Vec3& foot) {
        Joint joint{.first = first, .second = second, .type = "distance"};
        joint.r_first = first == ground ? foot : Vec3(Vec3(1, 2, -1) / 5);
        const Vec3 a = first == ground ? foot
                                       : Vec3(model.bodies[static_cast<std::size_t>(first)].start.x +
                                              model.bodies[static_cast<std::size_t>(first)].start.R * joint.r_first);
        joint.length = (model.bodies[static_cast<std::size_t>(second)].start.x - a).norm();
        model.joints.push_back(joint);
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            if (i + 1 < n) rod(at(i, j), at(i + 1, j), Vec3::Zero());
            if (j + 1 < n) rod(at(i, j), at(i, j + 1), Vec3::Zero());
        }
    for (const int corner : {at(0, 0), at(n - 1, 0), at(0, n - 1)})
        rod(ground, corner, model.bodies[static_cast<std::size_t>(corner)].start.x + Vec3(-1, -2, 3));
    model.gravity.g = Vec3(1, -2, -9);
    return model;
}

std::vector<Named> with_nets() {
    std::vector<Named> models = all();
    for (const int n : {2, 4, 6}) models.push_back({"net", net(n)});
    return models;
}

}  // namespace

TEST_CASE("dense, graph and sparse solves agree", "[solvers]") {
    for (const Named& named : with_nets()) {
        INFO(named.name);
        const auto dense = general_system(named.model, "SE3", SolverChoice::dense);
        const Answer expected = answer(*dense, named.model);
        const Real condition = dense->constraint_rank().condition.value_or(1);
        for (const SolverChoice choice : {SolverChoice::graph, SolverChoice::sparse, SolverChoice::automatic}) {
            const auto system = general_system(named.model, "SE3", choice);
            check_same(answer(*system, named.model), expected, condition);
        }
    }
}

TEST_CASE("the path for spherical joints agrees with the general one", "[solvers]") {
    int compared = 0;
    for (const Named& named : all()) {
        if (!takes_recursion(named.model)) continue;
        INFO(named.name);
        const auto general = general_system(named.model, "SO3xR3"), special = make_system(named.model, "SO3xR3");
        if (general->constraint_rank().rank < general->constraints()) continue;
        check_same(answer(*special, named.model), answer(*general, named.model),
                   general->constraint_rank().condition.value_or(1));
        ++compared;
    }
    CHECK(compared >= 15);
}
