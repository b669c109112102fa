// SPDX-License-Identifier: BSD-3-Clause
//
// A mechanism in other units is the same mechanism: lengths, masses and times multiplied by powers of two leave every
// bit of a solve, a rank, a multiplier and a start unchanged, and a start refused in metres is refused in micrometres.
#include "mechanics/joints/joint_rows.hpp"
#include "mechanics/model/scales.hpp"
#include "mechanics/start.hpp"
#include "tests/mechanics/models/models.hpp"
#include "tests/mechanics/models/scaled.hpp"

using namespace kreisel;
using namespace models;

namespace {

/// Units of the rows of C times a force, of joints in the order of the model: rows without a position level last.
std::vector<Real> multiplier_units(const Model& model, const Units& u) {
    std::vector<Real> positions, velocities;
    for (const Joint& joint : model.joints)
        for (int k = 0; k < rows_of(joint.type); ++k)
            (k < position_rows_of(joint.type) ? positions : velocities)
                .push_back(is_direction_row(joint.type, k) ? u.torque() : u.force());
    positions.insert(positions.end(), velocities.begin(), velocities.end());
    return positions;
}

struct RowsSolved {
    Status status;
    VecX a, lambda;
    ConstraintRank rank;
};

RowsSolved solved(const Model& model, const std::string& formulation) {
    const auto s = make_system(model, formulation);
    const auto y = initial_state(*s, model);
    RowsSolved result{Status::ok, VecX::Zero(s->velocities()), VecX::Zero(s->constraints()), s->constraint_rank()};
    result.status = s->accelerations(0, y.data(), s->v(y.data()), result.a.data(),
                                     result.lambda.size() > 0 ? result.lambda.data() : nullptr);
    return result;
}

/// What differs in a bit in other units, or nothing.
std::string difference(const Model& model, const Model& other, const Units& u, const std::string& formulation) {
    const RowsSolved here = solved(model, formulation), there = solved(other, formulation);
    if (here.status != there.status) return "status";
    if (here.rank.rank != there.rank.rank || here.rank.redundant != there.rank.redundant) return "rank";
    if (here.rank.condition != there.rank.condition) return "condition";
    const Eigen::Index block = make_system(model, formulation)->mass_block();
    for (Eigen::Index i = 0; i < here.a.size(); ++i) {
        const bool linear = block == 6 && i % 6 < 3;
        if (here.a[i] * (linear ? u.acceleration() : Real(1 / (u.T() * u.T()))) != there.a[i]) return "acceleration";
    }
    const std::vector<Real> units = multiplier_units(model, u);
    for (Eigen::Index i = 0; i < here.lambda.size(); ++i)
        if (here.lambda[i] * units[static_cast<std::size_t>(i)] != there.lambda[i]) return "multiplier";
    return "";
}

std::vector<Named> mechanisms() {
    std::vector<Named> models = all();
    for (const int n : {2, 3}) models.push_back({"hinges in line", hinges_in_line(0, n)});
    return models;
}

/// Moved off its joints, in units of its own.
Model moved_off(Model model) {
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        BodyState& s = model.bodies[i].start;
        s.x += Vec3(1, -2, Real(static_cast<int>(i))) / 512, s.v += Vec3(-1, 1, 2) / 256;
        if (model.bodies[i].point) continue;
        s.R *= SO3::exp(Vec3(1, 2, -1) / 512), s.omega += Vec3(2, 1, -1) / 256;
    }
    return model;
}

bool same_start(const Model& model, const Model& other, const Units& u) {
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const BodyState a = scaled(model.bodies[i].start, u), &b = other.bodies[i].start;
        if (a.x != b.x || a.R != b.R || a.v != b.v || a.omega != b.omega) return false;
    }
    return true;
}

std::string refusal(const Model& model) {
    try {
        check_start(model);
    } catch (const ParameterError& error) { return error.what(); }
    return "";
}

/// Two bars on hinges, some `size` long, `place` away from the origin.
Model two_bars(const Real& size, const Vec3& place = Vec3::Zero()) {
    Model model = bodies_in_a_row(2);
    const Vec3 omega(0, 0, 3);
    for (std::size_t i = 0; i < 2; ++i) {
        Body& body = model.bodies[i];
        body.mass = 1, body.J = size * size * Mat3(Vec3(1, 8, 8).asDiagonal()) / 100;
        body.start = {place + size * Vec3(Real(static_cast<int>(2 * i + 1)) / 2, 0, 0), Mat3::Identity(), Vec3::Zero(),
                      omega};
        body.start.v = omega.cross(body.start.x - place);
    }
    model.join(ground, 0, place, "revolute", Vec3::UnitZ());
    model.join(0, 1, place + size * Vec3::UnitX(), "revolute", Vec3::UnitZ());
    return model;
}

}  // namespace

TEST_CASE("other units change no bit of a solve", "[units]") {
    for (const Named& named : mechanisms())
        for (const Units& u : other_units()) {
            const Model other = scaled(named.model, u);
            for (const std::string& formulation : applicable(named.model)) {
                if (KREISEL_QUAD && formulation == "S3xR3") continue;  // the same code, slow
                INFO(named.name << " as " << formulation << ": " << u.length << " " << u.mass << " " << u.time);
                CHECK(difference(named.model, other, u, formulation) == "");
            }
        }
}

TEST_CASE("what is left in its old unit shows", "[units][control]") {
    const Units u{.length = 3, .mass = -7, .time = 5};
    const Model model = jointed("revolute");
    const auto shows = [&](auto spoil) {
        Model other = scaled(model, u);
        spoil(other);
        return difference(model, other, u, "SE3");
    };
    CHECK(shows([](Model&) {}) == "");
    CHECK(shows([](Model& m) { m.gravity.g *= 2; }) != "");
    CHECK(shows([](Model& m) { m.bodies[1].mass *= 1 + 4 * epsilon; }) != "");
    CHECK(shows([](Model& m) { m.joints[1].r_first[0] *= 1 + 4 * epsilon; }) != "");
    CHECK(shows([](Model& m) { m.bodies[0].start.omega[2] *= 1 + 4 * epsilon; }) != "");
}

TEST_CASE("other units change no bit of a projected start", "[units]") {
    for (const Named& named : mechanisms()) {
        if (named.model.joints.empty()) continue;
        Model moved = moved_off(named.model);
        std::vector<Model> others;
        for (const Units& u : other_units()) others.push_back(scaled(moved, u));
        const StartCorrection correction = project_start(moved);
        CHECK_FALSE(correction.noise);
        for (std::size_t i = 0; i < others.size(); ++i) {
            const Units u = other_units()[i];
            INFO(named.name << ": " << u.length << " " << u.mass << " " << u.time);
            const StartCorrection there = project_start(others[i]);
            CHECK(same_start(moved, others[i], u));
            CHECK(there.position == correction.position * u.L());
            CHECK(there.omega == correction.omega / u.T());
            CHECK_FALSE(there.noise);
            CHECK(refusal(others[i]) == "");
            if (KREISEL_QUAD && i > 3) break;
        }
        CHECK(project_start(moved).noise);
    }
}

TEST_CASE("other units change no bit of velocities that follow from the joints", "[units]") {
    for (const Named& named : mechanisms()) {
        const std::vector<bool> given(named.model.bodies.size(), false);
        Model model = named.model;
        complete_velocities(model, given);
        for (const Units& u : other_units()) {
            INFO(named.name << ": " << u.length << " " << u.mass << " " << u.time);
            Model other = scaled(named.model, u);
            complete_velocities(other, given);
            CHECK(same_start(model, other, u));
        }
    }
}

TEST_CASE("a start is refused by its own size, and not by that of a metre or a second", "[units]") {
    const Real million = 1000000;
    for (const Real& size : {Real(1 / million), Real(1) / 1000, Real(1), Real(1000)}) {
        INFO(to_double(size));
        const Model good = two_bars(size);
        CHECK(refusal(good) == "");
        Model apart = good;
        apart.bodies[1].start.x[1] += size / million;
        CHECK_THAT(refusal(apart), Catch::Contains("position level"));
        Model twisted = good;
        twisted.bodies[1].start.R = SO3::exp(Vec3(1, 0, 0) / million);
        CHECK_THAT(refusal(twisted), Catch::Contains("position level"));
        for (const Real& slower : {Real(1), Real(1 / million / million), Real(million * million)}) {
            INFO("rate " << to_double(slower));
            Model moving = good;
            for (Body& body : moving.bodies) body.start.v *= slower, body.start.omega *= slower;
            CHECK(refusal(moving) == "");
            moving.bodies[1].start.v[0] += 3 * size * slower / million;
            CHECK_THAT(refusal(moving), Catch::Contains("velocity level"));
            moving.bodies[1].start.v[0] -= 3 * size * slower / million;
            moving.bodies[1].start.omega[0] += 3 * slower / million;
            CHECK_THAT(refusal(moving), Catch::Contains("velocity level"));
        }
    }
}

TEST_CASE("at rest without forces no velocity counts as small", "[units]") {
    Model model = two_bars(1);
    for (Body& body : model.bodies) body.start.v.setZero(), body.start.omega.setZero();
    CHECK(refusal(model) == "");
    model.bodies[1].start.v[0] = Real(1) / 1000000000000;
    CHECK_THAT(refusal(model), Catch::Contains("velocity level"));
    model.gravity.g = Vec3(0, -1, 0);  // the bars will rotate at about 1/s
    CHECK(refusal(model) == "");
}

TEST_CASE("far from the origin round-off of positions is accepted, and a violation is not", "[units]") {
    const Vec3 place(600000, -500000, 620000);
    const Real ulp = Real(1) / 8589934592;  // of a double near a million
    Model model = two_bars(1, place);
    CHECK(abs(extent(model) - extent(two_bars(1))) <= 8 * ulp);
    CHECK(abs(row_scale(model, model.joints[0], 0) - row_scale(two_bars(1), two_bars(1).joints[0], 0)) <= 8 * ulp);
    model.bodies[1].start.x += 4 * ulp * Vec3(1, -1, 1);
    CHECK(refusal(model) == "");
    CHECK(project_start(model).noise);
    model.bodies[1].start.x += Vec3(1, -1, 1) / 1000000;
    CHECK_THAT(refusal(model), Catch::Contains("position level"));
    CHECK_FALSE(project_start(model).noise);
}

TEST_CASE("a rank does not depend on masses", "[units]") {
    for (const Real& ratio : {Real(1) / 1000000000, Real(1000000000), Real(1000000000) * 1000000000}) {
        INFO(to_double(ratio));
        Model model = jointed("revolute");
        model.bodies[1].mass *= ratio, model.bodies[1].J *= ratio;
        CHECK(make_system(model, "SE3")->constraint_rank().rank == 15);
        Model loops = closed_loop();
        loops.bodies[1].mass *= ratio, loops.bodies[1].J *= ratio;
        CHECK(make_system(loops, "SE3")->constraint_rank().rank == 16);
        Model hinges = hinges_in_line(0, 3);
        hinges.bodies[1].mass *= ratio, hinges.bodies[1].J *= ratio;
        CHECK(make_system(hinges, "SE3")->constraint_rank().rank == 8);
    }
}
