// SPDX-License-Identifier: BSD-3-Clause
//
// What every registered method and projection must do, whatever its order.
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
        for (const Named& named : all())
            for (const std::string& formulation : applicable(named.model)) {
                if (!runs_on(entry.description, formulation)) continue;
                INFO(entry.description.name << " on " << named.name << " as " << formulation);
                f(entry, named, formulation);
            }
}

Real difference(const std::vector<Real>& a, const std::vector<Real>& b) {
    Real worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) worst = max(worst, Real(abs(a[i] - b[i])));
    return worst;
}

/// Distance from the start after ten steps and the same ten backwards, relative to the largest entry of the start.
Real return_defect(const Model& model, const std::string& formulation, const Method& entry) {
    Trip trip(model, formulation, entry);
    const auto before = trip.y;
    const Real h = Real(1) / 512;
    for (int i = 0; i < 10; ++i) REQUIRE(trip.integrator->step(h * i, h, trip.y.data()) == Status::ok);
    for (int i = 10; i > 0; --i) REQUIRE(trip.integrator->step(h * i, -h, trip.y.data()) == Status::ok);
    Real size = 1;
    for (const Real& entry_of_y : before) size = max(size, Real(abs(entry_of_y)));
    return difference(before, trip.y) / size;
}

}  // namespace

TEST_CASE("a step of length zero leaves the state", "[methods]") {
    for_each_run([](const Method& entry, const Named& named, const std::string& formulation) {
        Trip trip(named.model, formulation, entry);
        const auto before = trip.y;
        REQUIRE(trip.integrator->step(0, 0, trip.y.data()) == Status::ok);
        CHECK(difference(before, trip.y) <= 16 * epsilon);
    });
}

TEST_CASE("a step back returns near the start", "[methods]") {
    // The defect of forward and back is of the size of the local error, h^(p+1), with a generous constant.
    for_each_run([](const Method& entry, const Named& named, const std::string& formulation) {
        if (named.name == "heavy_top") return;  // spins too fast for this h
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
        for (const Real& defect : defects)
            CHECK(defect <= 1000000 * pow(h, entry.description.order.configuration + 1) + 1000 * epsilon);
    });
}

TEST_CASE("symmetric methods return to the start, to round-off", "[methods]") {
    for_each_run([](const Method& entry, const Named& named, const std::string& formulation) {
        if (entry.description.symmetric) CHECK(return_defect(named.model, formulation, entry) <= 10000 * epsilon);
    });
}

TEST_CASE("the return above sees a method that is not symmetric", "[methods][control]") {
    for (const char* name : {"rkmk/midpoint", "rkmk/heun"})
        CHECK(return_defect(standard("forced_heavy_top"), "SO3", method(name)) > 1000000 * epsilon);
}

TEST_CASE("solves of the dynamics per step are as declared", "[methods]") {
    for_each_run([](const Method& entry, const Named& named, const std::string& formulation) {
        if (entry.description.implicit) return;  // as many as the Newton iteration takes
        Trip trip(named.model, formulation, entry);
        REQUIRE(trip.run(Real(1) / 10, 100) == Status::ok);
        CHECK(trip.system->evaluations() == 100 * entry.description.stages);
    });
}

TEST_CASE("after start, a step does not depend on the steps before it", "[methods]") {
    for_each_run([](const Method& entry, const Named& named, const std::string& formulation) {
        const Real h = Real(1) / 1000;
        Trip fresh(named.model, formulation, entry), used(named.model, formulation, entry);
        REQUIRE(used.run(Real(1) / 100, 10) == Status::ok);
        used.y = fresh.y;
        REQUIRE(used.integrator->start(0, used.y.data()) == Status::ok);
        REQUIRE(fresh.integrator->start(0, fresh.y.data()) == Status::ok);
        REQUIRE(fresh.integrator->step(0, h, fresh.y.data()) == Status::ok);
        REQUIRE(used.integrator->step(0, h, used.y.data()) == Status::ok);
        CHECK(fresh.y == used.y);
    });
}

TEST_CASE("NaN in the state is answered by a status, and the state is left alone", "[methods]") {
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

TEST_CASE("quaternions renormalised stay on the sphere; without, R drifts off SO(3)", "[methods]") {
    const auto defect = [](bool renormalise) {
        Trip trip(standard("forced_heavy_top"), "SO3", method("baseline/rk4_quaternion"), {{"renormalise", renormalise}});
        REQUIRE(trip.run(10, 500) == Status::ok);
        return trip.system->group().orthogonality_defect(trip.y.data());
    };
    CHECK(defect(true) <= 100 * epsilon);
    CHECK(defect(false) >= 1000000 * epsilon);
}

TEST_CASE("a projection moves nothing on the constraints and repairs what is off them", "[methods]") {
    for (const ProjectionMethod& entry : projections())
        for (const Named& named : all())
            for (const std::string& formulation : applicable(named.model)) {
                const auto& only = entry.description.formulations;
                if (!only.empty() && std::find(only.begin(), only.end(), formulation) == only.end()) continue;
                INFO(entry.description.name << " on " << named.name << " as " << formulation);
                Trip trip(named.model, formulation, method("rkmk/rk4"), entry.description.name);
                const auto before = trip.y;
                REQUIRE(trip.project->project(0, trip.y.data()) == Status::ok);
                CHECK(difference(before, trip.y) <= 100000 * epsilon);
                if (entry.description.name == "none") continue;
                for (std::size_t i = 0; i < trip.y.size(); ++i) {
                    const bool rotation = static_cast<int>(i) < trip.system->group().size() && i % 12 >= 3;
                    if (!rotation || trip.system->constraints() == 0)
                        trip.y[i] += Real(static_cast<int>(i % 5) - 2) / 1000;
                }
                if (trip.system->constraints() == 0) continue;
                REQUIRE(trip.position_defect() > Real(1) / 10000);
                REQUIRE(trip.project->project(0, trip.y.data()) == Status::ok);
                const std::string& name = entry.description.name;
                if (name != "velocity") CHECK(trip.position_defect() <= 1000 * epsilon);
                if (name != "position") CHECK(trip.velocity_defect() <= 10000 * epsilon);
            }
}

TEST_CASE("the mass-weighted projection is the nearest point in the mass metric", "[methods]") {
    // At the minimum the velocity correction is M-orthogonal to every velocity that satisfies the constraints.
    Trip trip(standard("double_pendulum"), "SO3xR3", method("rkmk/rk4"), "velocity");
    System& s = *trip.system;
    const auto n = static_cast<std::size_t>(s.velocities());
    Real* v = trip.y.data() + s.group().size();
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
            Eigen::Map<Eigen::Matrix<Real, 6, 6>>(&blocks[static_cast<std::size_t>(36 * i)]) * correction.segment<6>(6 * i);
    const VecX zero = VecX::Zero(s.constraints());
    for (int k = 0; k < 12; ++k) {
        f = VecX::Unit(s.velocities(), k);
        REQUIRE(s.solve_kkt(0, trip.y.data(), f.data(), zero.data(), tangent.data(), nullptr) == Status::ok);
        CHECK(abs(tangent.dot(M_correction)) <= 1000 * epsilon);
    }
}

TEST_CASE("names are unique, match their files, and every file registers", "[methods]") {
    const std::string root = build::source_dir;
    const auto check = [&](const std::string& name, const std::string& file, const std::string& folder) {
        INFO(name << " in " << file);
        // Compilers and caches may shorten the path of the root, not what lies below it.
        CHECK(file.ends_with("/" + folder + name + ".cpp"));
        CHECK(std::ifstream(root + "/" + folder + name + ".cpp").good());
    };
    std::set<std::string> names;
    for (const Method& entry : methods()) {
        check(entry.description.name, entry.file, "methods/");
        CHECK(names.insert(entry.description.name).second);
        CHECK(entry.description.order.configuration >= 1);
        CHECK((entry.description.implicit || entry.description.stages >= 1));
        CHECK_FALSE(entry.description.summary.empty());
        CHECK_FALSE(entry.description.cites.empty());
    }
    for (const ProjectionMethod& entry : projections()) check(entry.description.name, entry.file, "methods/projection/");
    for (const Problem& entry : problems()) check(entry.description.name, entry.file, "problems/");
}
