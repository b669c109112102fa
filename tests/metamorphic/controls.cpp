// SPDX-License-Identifier: BSD-3-Clause
//
// Faults that the suite must find, each next to the same comparison without it.
#include <catch2/catch.hpp>

#include "tests/metamorphic/descriptions/freed.hpp"
#include "tests/metamorphic/doubles.hpp"
#include "tests/metamorphic/suite.hpp"

using namespace kreisel;
using namespace kreisel::metamorphic;

namespace {

constexpr int few = KREISEL_QUAD ? 16 : 64;

std::string judged(const std::string& model, const std::string& change, const Combination& combination,
                   const Bench& bench = {}, int count = few) {
    Report report;
    return objection({&named_model(model), &transformation(change), combination}, count, bench, report);
}

const Combination plain = {"rkmk/rk4", "SO3xR3", "none"};

}  // namespace

TEST_CASE("control: a projection that stops by one number for all rows", "[metamorphic]") {
    const Combination projected = {"rkmk/rk4", "SO3xR3", "position_velocity"};
    const int many = 64;  // until the drift in metres exceeds the tolerance
    for (const char* model : {"double_pendulum", "closed loop"}) {
        CHECK(judged(model, "lengths times 2^-20", projected, {}, many) == "");
        CHECK(judged(model, "lengths times 2^-20", projected, with_absolute_tolerance(), many) != "");
    }
}

TEST_CASE("control: a torsion spring that forgets full turns", "[metamorphic]") {
    CHECK(judged("winding", "zero of torsion moved", plain, {}, 64) == "");
    CHECK(judged("winding", "zero of torsion moved", plain, with_forgetful_springs(), 64) != "");
}

TEST_CASE("control: a multiplier of a rolling joint with the other sign", "[metamorphic]") {
    for (const char* model : {"rolling_disk", "rolling"}) {
        CHECK(freed_difference(named_model(model).model) <= 1000000 * epsilon);
        CHECK(freed_difference(named_model(model).model, with_reversed_rolling_row()) > Real(1) / 100);
    }
}

TEST_CASE("control: an unrequested force", "[metamorphic]") {
    CHECK(judged("multibody", "renamed", plain) == "");
    CHECK(judged("multibody", "renamed", plain, with_uninvited_spring()) != "");
}

TEST_CASE("control: a hidden time", "[metamorphic]") {
    CHECK(judged("double_pendulum", "time times 2^3", plain) == "");
    CHECK(judged("double_pendulum", "time times 2^3", plain, with_hidden_time()) != "");
}
