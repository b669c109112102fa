// SPDX-License-Identifier: BSD-3-Clause
//
// What every registered method and projection must do, whatever its order.
#include <cmath>
#include <fstream>
#include <set>

#include "kreisel_build.hpp"
#include "tests/methods/stepping.hpp"

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

template <class F>
void for_each_run(F f) {
    for (const Method& entry : methods())
        for (const Named& named : for_methods())
            for (const std::string& formulation : applicable(named.model)) {
                if (!runs_on(entry, named.model, formulation)) continue;
                if (KREISEL_QUAD && named.model.bodies.size() != 1 && formulation != "SO3xR3") continue;  // slow
                INFO(entry.description.name << " on " << named.name << " as " << formulation);
                f(entry, named, formulation);
            }
}

Real difference(const std::vector<Real>& a, const std::vector<Real>& b) {
    Real worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) worst = max(worst, Real(abs(a[i] - b[i])));
    return worst;
}

/// The larger of 1 and the largest entry.
Real size(const std::vector<Real>& a) {
    Real largest = 1;
    for (const Real& entry : a) largest = max(largest, Real(abs(entry)));
    return largest;
}

}  // namespace

TEST_CASE("a step of length zero leaves the state", "[methods]") {
    for_each_run([](const Method& entry, const Named& named, const std::string& formulation) {
        Trip trip(named.model, formulation, entry);
        const auto before = trip.y;
        REQUIRE(trip.integrator->step(0, 0, trip.y.data()) == Status::ok);
        CHECK(difference(before, trip.y) <= 16 * epsilon * size(before));  // velocities may be held as momenta
    });
}

TEST_CASE("a step of length zero leaves attitudes that are half a turn away", "[methods]") {
    // Coordinates are computed by other branches there, one for each axis.
    const Vec3 turns[] = {Vec3(3, 0, 0), Vec3(0, 3, 0), Vec3(0, 0, 3), Vec3(2, 1, 2), Vec3(-1, 2, -2)};
    for (const Method& entry : methods()) {
        if (!runs_on(entry, standard("forced_heavy_top"), "SO3")) continue;
        for (const Vec3& turn : turns) {
            INFO(entry.description.name << ", " << turn.transpose());
            Trip trip(standard("forced_heavy_top"), "SO3", entry);
            store(SO3::exp(turn), trip.y.data());
            const auto before = trip.y;
            REQUIRE(trip.integrator->step(0, 0, trip.y.data()) == Status::ok);
            CHECK(difference(before, trip.y) <= 16 * epsilon);
        }
    }
}

TEST_CASE("a step back returns near the start", "[methods]") {
    // The defect of forward and back is of the size of the local error, (rate h)^(p+1), with a generous constant and
    // rates up to 16/s; formulas of several steps, which reach further, see higher derivatives, 36/s of the
    // slider-crank.
    for_each_run([](const Method& entry, const Named& named, const std::string& formulation) {
        if (spins_fast(named.model)) return;
        Real defects[2];
        for (int i = 0; i < 2; ++i) {
            Trip trip(named.model, formulation, entry);
            const auto before = trip.y;
            const Real h = Real(i == 0 ? 1 : -1) / 256;
            REQUIRE(trip.integrator->step(0, h, trip.y.data()) == Status::ok);
            REQUIRE(difference(before, trip.y) > 0);
            REQUIRE(trip.integrator->step(h, -h, trip.y.data()) == Status::ok);
            defects[i] = difference(before, trip.y);
        }
        const Real h = Real(1) / 256;
        // Velocities that follow from positions alone are quotients of them: wrong by h^p from the first step on.
        const bool quotients = entry.description.meets_positions && !entry.description.meets_velocities;
        const int power = entry.description.order.configuration + (quotients ? 0 : 1);
        const Real constant = max(Real(1000000), Real(pow(Real(entry.description.keeps_memory ? 40 : 16), power)));
        for (const Real& defect : defects) CHECK(defect <= constant * pow(h, power) + 1000 * epsilon);
    });
}

TEST_CASE("NaN in the state gives a status, and the state is unchanged", "[methods]") {
    for_each_run([](const Method& entry, const Named& named, const std::string& formulation) {
        Trip trip(named.model, formulation, entry);
        trip.y.back() = std::numeric_limits<Real>::quiet_NaN();  // omega of the last body
        const auto before = trip.y;
        CHECK(trip.integrator->step(0, Real(1) / 1000, trip.y.data()) != Status::ok);
        for (std::size_t i = 0; i + 1 < before.size(); ++i) CHECK(trip.y[i] == before[i]);
    });
}

TEST_CASE("a stage that leaves the chart of exp is a status", "[methods]") {
    Trip trip(standard("heavy_top"), "SO3", method("rkmk/rk4"));
    CHECK(trip.integrator->step(0, Real(1) / 10, trip.y.data()) == Status::left_chart);
}

TEST_CASE("Euler angles report their singularity", "[methods]") {
    ParameterValues values = defaults(problem("heavy_top"));
    values["omega"] = Vector3{4, 0, 0};  // the axis y swings through the vertical
    values["gravity"] = Vector3{0, 0, 0};
    Trip trip(problem("heavy_top").build(Parameters(values)), "SO3", method("baseline/rk4_euler_angles"));
    CHECK(trip.run(1, 1000) == Status::chart_singularity);
}

TEST_CASE("Euler angles end a step that could jump their singularity, and no other", "[methods]") {
    const double theta = std::acos(0.03);  // body y is so far from the vertical, and swings by 0.1 rad/s
    ParameterValues values = defaults(problem("heavy_top"));
    values["gravity"] = Vector3{0, 0, 0};
    values["R"] = Matrix3{1, 0, 0, 0, std::cos(theta), -std::sin(theta), 0, std::sin(theta), std::cos(theta)};
    values["omega"] = Vector3{0.1, 150, 0};
    const Model model = problem("heavy_top").build(Parameters(values));
    const auto step = [&](const Real& h) {
        Trip trip(model, "SO3", method("baseline/rk4_euler_angles"));
        return trip.integrator->step(0, h, trip.y.data());
    };
    CHECK(step(Real(1) / 100) == Status::ok);
    CHECK(step(-Real(1) / 100) == Status::ok);
    CHECK(step(Real(1) / 2) == Status::chart_singularity);
}

TEST_CASE("Euler angles end such a step about the other axis too", "[methods]") {
    const double theta = std::acos(0.03), c = std::cos(theta), s = std::sin(theta);
    ParameterValues values = defaults(problem("heavy_top"));
    values["gravity"] = Vector3{0, 0, 0};
    values["R"] = Matrix3{0, 0, 1, s, c, 0, -c, s, 0};  // turned on by pi/2 about body y, which z swings now
    values["omega"] = Vector3{0, 0, 0.1};
    Trip trip(problem("heavy_top").build(Parameters(values)), "SO3", method("baseline/rk4_euler_angles"));
    const auto start = trip.y;
    CHECK(trip.integrator->step(0, Real(1) / 100, trip.y.data()) == Status::ok);
    trip.y = start;
    CHECK(trip.integrator->step(0, Real(1) / 2, trip.y.data()) == Status::chart_singularity);
}

TEST_CASE("quaternions renormalised stay on the sphere; without, R drifts off SO(3)", "[methods]") {
    const auto defect = [](bool renormalise) {
        Trip trip(standard("forced_heavy_top"), "SO3", method("baseline/rk4_quaternion"),
                  {{"renormalise", renormalise}});
        REQUIRE(trip.run(10, 500) == Status::ok);
        return trip.system->group().orthogonality_defect(trip.y.data());
    };
    CHECK(defect(true) <= 100 * epsilon);
    CHECK(defect(false) >= 1000000 * epsilon);
}

TEST_CASE("the mass-weighted projection is the nearest point in the mass metric", "[methods]") {
    // At the minimum the velocity correction is M-orthogonal to every velocity that satisfies the constraints.
    Trip trip(standard("double_pendulum"), "SO3xR3", method("rkmk/rk4"), "velocity");
    System& s = *trip.system;
    const auto n = static_cast<std::size_t>(s.velocities());
    Real* v = s.v(trip.y.data());
    VecX before(s.velocities()), correction(s.velocities()), tangent(s.velocities()), f(s.velocities());
    for (std::size_t i = 0; i < n; ++i) v[i] += sin(Real(static_cast<int>(i)));
    before = Eigen::Map<VecX>(v, s.velocities());
    REQUIRE(trip.project->project(0, trip.y.data()) == Status::ok);
    correction = Eigen::Map<VecX>(v, s.velocities()) - before;
    REQUIRE(correction.norm() > Real(1) / 10);
    std::vector<Real> blocks(36 * 2);
    s.mass(trip.y.data(), blocks.data());
    VecX M_correction(s.velocities());
    for (int i = 0; i < 2; ++i)
        M_correction.segment<6>(6 * i) =
            Eigen::Map<Eigen::Matrix<Real, 6, 6>>(&blocks[static_cast<std::size_t>(36 * i)]) *
            correction.segment<6>(6 * i);
    const VecX zero = VecX::Zero(s.constraints());
    for (int k = 0; k < 12; ++k) {
        f = VecX::Unit(s.velocities(), k);
        REQUIRE(s.solve_kkt(0, trip.y.data(), f.data(), zero.data(), tangent.data(), nullptr) == Status::ok);
        CHECK(abs(tangent.dot(M_correction)) <= 1000 * epsilon);
    }
}

TEST_CASE("the seed's projection in the metric of M is the mass-weighted one, near the constraints", "[methods]") {
    // On tangents its metric of R^{3x3} is J, and at rest positions and velocities do not mix: to first order in the
    // distance both give the same point.
    Model model = standard("double_pendulum");
    for (Body& body : model.bodies) {
        body.start.omega.setZero(), body.start.v.setZero();
        body.J << 3, 1, -1, 1, 5, 1, -1, 1, 4;
    }
    const Real distance = Real(1) / (1 << 20);
    const auto projected = [&](const std::string& name, const OptionValues& options) {
        const Method& rk4 = method("rkmk/rk4");
        Trip trip(model, "SO3xR3", rk4, default_options(rk4.description.options), name, options);
        const int n = trip.system->velocities();
        Real* v = trip.system->v(trip.y.data());
        std::vector<Real> u(static_cast<std::size_t>(n));
        for (int i = 0; i < n; ++i)
            u[static_cast<std::size_t>(i)] = distance * sin(Real(i + 1)), v[i] = distance * cos(Real(3 * i));
        trip.system->group().append_exp(trip.y.data(), u.data(), trip.y.data());
        const auto before = trip.y;
        REQUIRE(trip.project->project(0, trip.y.data()) == Status::ok);
        REQUIRE(difference(before, trip.y) > distance / 4);
        return trip.y;
    };
    const auto nearest = projected("position_velocity", {});
    const auto seed = [&](const char* weight) { return difference(projected("terze", {{"weight", weight}}), nearest); };
    CHECK(seed("mass") <= 20 * distance * distance);
    CHECK(seed("identity") > distance / 100);
}

TEST_CASE("names are unique, match their files, and every file registers", "[methods]") {
    const std::string root = build::source_dir;
    const auto check = [&](const std::string& name, const std::string& file, const std::string& folder) {
        INFO(name << " in " << file);
        // Compilers and caches may shorten the path of the root, not the part below it.
        CHECK(file.ends_with("/" + folder + name + ".cpp"));
        CHECK(std::ifstream(root + "/" + folder + name + ".cpp").good());
    };
    std::set<std::string> names;
    for (const Method& entry : methods()) {
        check(entry.description.name, entry.file, "methods/");
        CHECK(names.insert(entry.description.name).second);
        CHECK(entry.description.order.configuration >= 1);
        CHECK((entry.description.is_implicit() || entry.description.own_control ||
               entry.description.stages + entry.description.force_evaluations >= 1));
        CHECK_FALSE(entry.description.summary.empty());
        CHECK_FALSE(entry.description.cites.empty());
    }
    for (const ProjectionMethod& entry : projections())
        check(entry.description.name, entry.file, "methods/projection/");
    for (const Problem& entry : problems()) check(entry.description.name, entry.file, "problems/");
}
