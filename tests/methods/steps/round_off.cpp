// SPDX-License-Identifier: BSD-3-Clause
//
// What a step keeps up to round-off, many steps keep up to little more: a step must not be rounded to the same side
// again and again.
#include "tests/methods/stepping.hpp"

namespace round_off_of_steps {

using namespace kreisel;
using namespace models;
using namespace stepping;

namespace {

constexpr long steps = 20000;

Model free_body(const Mat3& J) {
    Model model = standard("free_top");
    model.bodies[0].J = J;
    model.bodies[0].start.omega = Vec3(2, -1, 3) / 2;
    return model;
}

/// Inertias of which the inverse is not exact.
std::vector<Mat3> inertias() {
    Mat3 full;
    full << 3, 1, -1, 1, 5, 1, -1, 1, 4;
    return {Mat3(Vec3(2, 1, Real(2) / 3).asDiagonal()), Mat3(Vec3(3, 1, 2).asDiagonal()), full};
}

/// Largest change of |m| of a free body at the end of the steps, over |m|.
Real change_of_momentum(const Method& entry, const OptionValues& options, const std::string& formulation,
                        const Real& h) {
    Real most = 0;
    for (const Mat3& J : inertias()) {
        Trip trip(free_body(J), formulation, entry, options);
        const auto momentum = [&] { return Real((J * trip.bodies()[0].omega).norm()); };
        const Real at_start = momentum();
        REQUIRE(trip.run(h * Real(steps), steps) == Status::ok);
        most = max(most, Real(abs(momentum() / at_start - 1)));
    }
    return most;
}

void check_that_it_stays(const char* name, const OptionValues& changed, const std::string& formulation) {
    const Method& entry = method(name);
    const OptionValues options = with_defaults(changed, entry.description.options);
    for (const Real& h : {Real(1) / 1024, Real(1) / 128}) {
        const Real change = change_of_momentum(entry, options, formulation, h);
        INFO(name << " as " << formulation << ", h = " << to_text(h) << ": " << to_text(Real(change / epsilon)));
        CHECK(change < 1000 * epsilon);
    }
}

/// At most what round-off at random makes of the steps, of a microsecond each.
void check_that_rotations_stay(const char* problem, const char* name, const OptionValues& changed,
                               const std::string& formulation, long short_steps) {
    const Method& entry = method(name);
    Trip trip(standard(problem), formulation, entry, with_defaults(changed, entry.description.options));
    REQUIRE(trip.run(Real(short_steps) / (1 << 20), short_steps) == Status::ok);
    const Real defect = trip.system->group().orthogonality_defect(trip.y.data());
    INFO(name << " of " << problem << " as " << formulation << ": " << to_text(Real(defect / epsilon)));
    CHECK(defect <= 2 * epsilon * sqrt(Real(short_steps)));
}

}  // namespace

TEST_CASE("round-off of implicit steps does not add up in what they keep", "[methods][round_off]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    for (const char* name : {"rkmk/implicit_midpoint", "rkmk/gauss2", "symmetric_projection/midpoint",
                             "symmetric_projection/gauss2", "variational/shakelie", "energy/simo_wong"})
        check_that_it_stays(name, {}, "SO3");
    for (const char* coordinates : {"exp", "cayley"})
        check_that_it_stays("variational/rattlie", {{"coordinates", std::string(coordinates)}}, "SO3");
}

TEST_CASE("round-off of short steps does not add up in the rotations", "[methods][round_off]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    for (const char* formulation : {"SO3", "SO3xR3", "SE3"})
        check_that_rotations_stay("heavy_top", "rkmk/rk4", {}, formulation, 100000);
    for (const char* formulation : {"SO3", "S3", "SO3-LiePoisson"}) {
        for (const char* name : {"crouch_grossman/cg4a", "commutator_free/cf4", "multistep/adams_bashforth4"})
            check_that_rotations_stay("free_top", name, {}, formulation, 30000);
        check_that_rotations_stay("free_top", "rkmk/rk4", {{"coordinates", std::string("cayley")}}, formulation, 30000);
    }
}

TEST_CASE("a method that does not keep a body's momentum is seen beside round-off", "[methods][round_off][control]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    CHECK(change_of_momentum(method("rkmk/rk4"), default_options(method("rkmk/rk4").description.options), "SO3",
                             Real(1) / 128) > 3000 * epsilon);
}

}  // namespace round_off_of_steps
