// SPDX-License-Identifier: BSD-3-Clause
//
// Redundant constraints: the accelerations are those without the redundant rows, the multipliers those of
// least norm, each row divided by its scale; against a dense least-norm solve. And constraints that contradict each
// other.
#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>

#include "mechanics/joints/joint_rows.hpp"
#include "mechanics/start.hpp"
#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

struct Redundant {
    std::string name;
    Model model;
    int rank;  // of all its rows, by the counting in the comment beside it
};

/// A joint of one kind, twice at the same place between the same bodies.
Model doubled(JointType type, bool both_grounded) {
    Model model = bodies_in_a_row(2);
    join(model, ground, 0, type, Vec3(1, -1, 2) / 3);
    join(model, both_grounded ? ground : 0, 1, type, Vec3(1, 2, 0) / 3);
    model.joints.push_back(model.joints.back());
    model.gravity.g = Vec3(1, -2, -9);
    project_start(model);
    return model;
}

int rows(const Model& model) {
    int sum = 0;
    for (const Joint& joint : model.joints) sum += rows_of(joint.type);
    return sum;
}

/// A planar four-bar of hinges with parallel axes: 20 rows, 3 of which are redundant because of the loop.
Model four_bar(const Vec3& axis, const Vec3& along, const Vec3& across) {
    Model model = bodies_in_a_row(3);
    const Vec3 corners[] = {Vec3::Zero(), Vec3(across), Vec3(across + 2 * along), Vec3(3 * along)};
    for (int i = 0; i < 3; ++i) {
        Body& body = model.bodies[static_cast<std::size_t>(i)];
        body.start.x = (corners[i] + corners[i + 1]) / 2, body.start.omega = Vec3::Zero();
    }
    for (int i = 0; i < 4; ++i) model.join(i == 0 ? ground : i - 1, i == 3 ? ground : i, corners[i], "revolute", axis);
    model.bodies[0].start.omega = model.bodies[0].start.R.transpose() * axis;
    model.gravity.g = Vec3(1, -2, -9);
    project_start(model);
    return model;
}

/// A body on two spherical joints and a hinge whose axis is their line.
Model door() {
    Model model = bodies_in_a_row(1);
    model.join(ground, 0, Vec3(0, 0, 1));
    model.join(ground, 0, Vec3(0, 0, -1));
    model.join(ground, 0, Vec3::Zero(), "revolute", Vec3::UnitZ());
    model.gravity.g = Vec3(1, -2, -9);
    project_start(model);
    return model;
}

/// A table on n legs of spherical ends: a body held by n rods.
Model rods(int n) {
    Model model = bodies_in_a_row(1);
    for (int i = 0; i < n; ++i) {
        const Vec3 foot(i % 3 - 1, Real(i * i % 5) / 2, -1 - i % 2),
            end = foot + Vec3(3 * i % 7 - 3, 5 * i % 11 - 5, 6 + i * i % 5) / 4;
        Joint joint{.r_first = foot, .r_second = model.point_of(0, end), .type = "distance"};
        joint.length = (end - foot).norm();
        model.joints.push_back(joint);
    }
    model.gravity.g = Vec3(1, -2, -9);
    project_start(model);
    return model;
}

std::vector<Redundant> redundant() {
    std::vector<Redundant> all;
    for (const JointType type : joint_types())
        for (const bool grounded : {true, false}) {
            Model model = doubled(type, grounded);
            const int rank = rows(model) - rows_of(type);
            all.push_back(
                {std::string("doubled ") + type.name() + (grounded ? " to the ground" : ""), std::move(model), rank});
        }
    for (const int n : {2, 3, 4}) {
        all.push_back({std::to_string(n) + " hinges in line", hinges_in_line(ground, n), 5});
        all.push_back({std::to_string(n) + " hinges in line between bodies", hinges_in_line(0, n), 8});
    }
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    const Mat3 R = SO3::exp(Vec3(1, -2, 1) / 2);
    for (const Mat3& turn : {Mat3(Mat3::Identity()), R, Mat3(R * R)}) {
        all.push_back({"four-bar", four_bar(turn * z, turn * x, turn * (x + 2 * y)), 17});
        all.push_back({"four-bar with other bars", four_bar(turn * y, turn * (x + z / 2), turn * (2 * z - x)), 17});
    }
    all.push_back({"door", door(), 5});
    for (const int n : {7, 8, 9}) all.push_back({std::to_string(n) + " rods", rods(n), 6});
    // Pairs of spherical joints: the distance of their points is already constant in both bodies.
    for (const int first : {ground, 0}) {
        for (const int more : {2, 3}) {
            Model model = bodies_in_a_row(2);
            if (first != ground) join(model, ground, 0, "revolute", Vec3(-1, 0, 1));
            for (int i = 0; i < more; ++i) model.join(first, 1, Vec3(i, i * i, 1 - i));
            project_start(model);
            all.push_back({std::to_string(more) + " spherical joints", model,
                           (first == ground ? 0 : 5) + 3 + (more == 2 ? 2 : 3)});
        }
    }
    // A fixed joint beside another joint makes that one redundant.
    for (const JointType type : {"revolute", "prismatic", "planar", "universal"}) {
        Model model = bodies_in_a_row(1);
        join(model, ground, 0, "fixed", Vec3(1, 0, 0));
        join(model, ground, 0, type, Vec3(0, 1, 0));
        project_start(model);
        all.push_back({std::string("fixed and ") + type.name(), model, 6});
    }
    return all;
}

/// a and the scaled multipliers of least norm, from dense factors of M and C.
struct LeastNorm {
    VecX a, lambda;
    VecX share;  // of each row in the null space of C^T
    int rank;
};

LeastNorm dense_solution(System& s, const std::vector<Real>& y) {
    const int n = s.velocities(), m = s.constraints();
    const Real* v = s.v(y.data());
    MatX M = MatX::Zero(n, n), C(m, n);
    std::vector<Real> blocks(static_cast<std::size_t>(6 * n));
    s.mass(y.data(), blocks.data());
    for (int i = 0; i < n; i += 6)
        M.block(i, i, 6, 6) = Eigen::Map<MatX>(&blocks[static_cast<std::size_t>(6 * i)], 6, 6);
    VecX Q(n), gyroscopic(n), xi(m), scale(m);
    s.applied_force(0, y.data(), v, Q.data());
    s.gyroscopic_force(y.data(), v, gyroscopic.data());
    Q += gyroscopic;
    s.jacobian(0, y.data(), C.data());
    s.acceleration_bias(0, y.data(), v, xi.data());
    s.row_scale(scale.data());
    const MatX L = M.llt().matrixL();
    const VecX free = M.llt().solve(Q);
    Eigen::JacobiSVD<MatX> weighted(L.triangularView<Eigen::Lower>().solve(C.transpose()).transpose(),
                                    Eigen::ComputeThinU | Eigen::ComputeThinV);
    weighted.setThreshold(Real(1) / 10000000);
    LeastNorm out;
    out.rank = static_cast<int>(weighted.rank());
    out.a = free + L.transpose().triangularView<Eigen::Upper>().solve(VecX(weighted.solve(VecX(xi - C * free))));
    // C^T lambda = Q - M a with lambda scaled: of all solutions the one of least norm.
    Eigen::JacobiSVD<MatX> transposed(MatX(C.transpose() * scale.cwiseInverse().asDiagonal()),
                                      Eigen::ComputeFullU | Eigen::ComputeFullV);
    transposed.setThreshold(Real(1) / 10000000);
    out.lambda = scale.cwiseInverse().cwiseProduct(VecX(transposed.solve(VecX(Q - M * out.a))));
    out.share = transposed.matrixV().rightCols(m - transposed.rank()).rowwise().norm();
    return out;
}

}  // namespace

TEST_CASE("redundant rows: right accelerations and multipliers of least norm", "[redundant]") {
    const std::vector<Redundant> all = redundant();
    CHECK(all.size() >= 40);
    for (const Redundant& named : all) {
        INFO(named.name);
        REQUIRE_NOTHROW(check_start(named.model));
        for (const std::string formulation : {"SO3xR3", "SE3", "S3xR3"}) {
            INFO(formulation);
            const auto s = make_system(named.model, formulation);
            const auto y = initial_state(*s, named.model);
            const LeastNorm expected = dense_solution(*s, y);
            const ConstraintRank rank = s->constraint_rank();
            CHECK(expected.rank == named.rank);
            CHECK(rank.rank == named.rank);
            CHECK(rank.rows == s->constraints());
            CHECK(static_cast<int>(rank.redundant.size()) == rank.rows - rank.rank);
            VecX a(s->velocities()), lambda(s->constraints());
            REQUIRE(s->accelerations(0, y.data(), s->v(y.data()), a.data(), lambda.data()) == Status::ok);
            const Real tolerance = sqrt(epsilon) / 1000;
            CHECK((a - expected.a).norm() <= tolerance * (1 + expected.a.norm()));
            CHECK((lambda - expected.lambda).norm() <= tolerance * (1 + expected.lambda.norm()));
            for (int row = 0; row < rank.rows; ++row) {
                INFO("row " << row << ", share " << to_double(expected.share[row]));
                CHECK(s->is_unique(row) == (expected.share[row] < Real(1) / 1000000));
            }
        }
    }
}

namespace {

/// Joints of which every multiplier is unique, where the model starts.
std::vector<bool> unique_joints(const Model& model) {
    const auto s = make_system(model, "SO3xR3");
    const auto y = initial_state(*s, model);
    VecX a(s->velocities()), lambda(s->constraints());
    REQUIRE(s->accelerations(0, y.data(), s->v(y.data()), a.data(), lambda.data()) == Status::ok);
    std::vector<bool> unique(model.joints.size(), true);
    const auto of = s->constraint_rows();
    for (std::size_t row = 0; row < of.size(); ++row)
        if (!s->is_unique(static_cast<int>(row))) unique[static_cast<std::size_t>(of[row].joint)] = false;
    return unique;
}

}  // namespace

TEST_CASE("joints outside of a redundant loop have unique reactions, those of the loop have not", "[redundant]") {
    Model model = door();
    model.bodies.push_back(asymmetric_body(1));
    model.join(0, 1, Vec3(1, 0, 1));
    project_start(model);
    CHECK(unique_joints(model) == std::vector<bool>{false, false, false, true});
    for (const char* linkage : {"four_bar", "bricard"}) {
        const auto unique = unique_joints(standard(linkage));
        CHECK(std::none_of(unique.begin(), unique.end(), [](bool one) { return one; }));
    }
    const auto independent = unique_joints(standard("double_pendulum"));
    CHECK(std::all_of(independent.begin(), independent.end(), [](bool one) { return one; }));
}

TEST_CASE("the dropped rows are named by joint", "[redundant]") {
    const auto s = make_system(door(), "SO3xR3");
    const ConstraintRank rank = s->constraint_rank();
    REQUIRE(rank.redundant.size() == 6);
    CHECK_THAT(rank.redundant.back(), Catch::Contains("joint 2 (ground - b0, revolute)"));
    REQUIRE(rank.condition);
    CHECK(*rank.condition >= 1);
}

TEST_CASE("the condition is the ratio of the extreme pivots", "[redundant]") {
    const Real angle = Real(1) / 5;
    Model model = bodies_in_a_row(1);
    const Vec3 centre = model.bodies[0].start.x;
    for (const Real& turn : {Real(0), angle})  // rods to the mass centre: columns of length 1 at that angle
        model.joints.push_back({.r_first = centre - Vec3(cos(turn), sin(turn), 0), .type = "distance", .length = 1});
    const auto condition = [&] { return make_system(model, "SO3xR3")->constraint_rank().condition.value_or(0); };
    CHECK(abs(condition() - 1 / sin(angle)) <= 100 * epsilon);
    model.joints.push_back(model.joints[1]);  // whichever of the three is left out
    CHECK(abs(condition() - 1 / sin(angle)) <= 100 * epsilon);
    model.joints.erase(model.joints.begin());
    CHECK(abs(condition() - 1) <= 100 * epsilon);
}

TEST_CASE("dropped rows hold at rest, and under a small drift", "[redundant]") {
    Model model = hinges_in_line(ground, 2);
    model.gravity.g.setZero();
    Body& body = model.bodies[1];
    body.J = Mat3::Identity();  // no gyroscopic torque: only the rows contain the centripetal acceleration
    for (const Real& speed : {Real(0), Real(1)}) {
        const Vec3 turning = speed * Vec3(1, -2, 4);
        body.start.omega = body.start.R.transpose() * turning;
        body.start.v = turning.cross(body.start.x - Vec3(1, 1, 1));
        for (const std::string formulation : {"SO3xR3", "SE3", "S3xR3"}) {
            INFO(formulation << " at " << to_double(speed));
            const auto s = make_system(model, formulation);
            Model drifted = model;
            drifted.bodies[1].start.R = SO3::exp(Vec3(1, -2, 0) / 100000) * body.start.R;
            for (const Model* at : {&model, &drifted}) {
                const auto y = initial_state(*s, *at);
                VecX a(s->velocities());
                CHECK(s->accelerations(0, y.data(), s->v(y.data()), a.data(), nullptr) == Status::ok);
            }
        }
    }
}
