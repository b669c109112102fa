// SPDX-License-Identifier: BSD-3-Clause
//
// How far apart two recorded numbers are.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "records/diff/recorded_number.hpp"

using namespace kreisel;

TEST_CASE("neighbouring doubles are one ulp apart, on either side of a power of two too") {
    for (const double x : {1.0, 0.1, -3.0, 1024.0, 5e-324, 1e-310, 1e308}) {
        for (const double towards : {-INFINITY, INFINITY}) {
            const double next = std::nextafter(x, towards);
            INFO(x << " " << next);
            CHECK(distance({x}, {next}).ulps == 1);
            CHECK(distance({next}, {x}).ulps == 1);
            CHECK(distance({x}, {next}).any());
        }
    }
    CHECK_FALSE(distance({0.1}, {0.1}).any());
    CHECK(distance({1.0}, {1 + 3 * std::numeric_limits<double>::epsilon()}).ulps == 3);
}

TEST_CASE("the sign of zero is not a difference, that of another number is") {
    CHECK_FALSE(distance({0.0}, {-0.0}).any());
    CHECK(distance({2.0}, {-2.0}).relative == 2);
    CHECK(distance({2.0}, {-2.0}).absolute == 4);
    CHECK(distance({0.0}, {1e-300}).relative == 1);
    const double largest = std::numeric_limits<double>::max();
    CHECK(distance({largest}, {-largest}).relative == 2);
    CHECK(std::isfinite(distance({largest}, {-largest}).ulps));
}

TEST_CASE("quad numbers are compared with 113 bits") {
    const RecordedNumber one = quad_number("1"), above = quad_number("1.00000000000000000000000000000000019259");
    CHECK(one.value == above.value);
    CHECK(distance(one, above).ulps == 1);
    CHECK(distance(one, above).relative == Approx(1.9e-34).epsilon(0.02));
    CHECK_FALSE(distance(quad_number("0.5"), quad_number("5.00000000000000000000000000000000000e-01")).any());
    // Too small for double, and still different.
    CHECK(distance(quad_number("1e-400"), quad_number("2e-400")).relative == 0.5);
}

TEST_CASE("text that is not a number is refused") {
    for (const char* text : {"", "1.0x", "nan", "inf", "x"}) {
        CHECK_THROWS_AS(quad_number(text), std::invalid_argument);
    }
    CHECK(quad_number("-1e-30").text() == "-1e-30");
    CHECK(RecordedNumber{0.1}.text() == "0.1");
}
