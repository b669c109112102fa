// SPDX-License-Identifier: BSD-3-Clause
#include "records/fits/fit.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "tests/plots/curves.hpp"

using namespace kreisel;

TEST_CASE("a straight line is fitted exactly, and its error is that of the textbook") {
    const FittedLine exact = fit_line({0, 1, 2, 3}, {1, 3, 5, 7});
    CHECK(exact.slope == Approx(2));
    CHECK(exact.intercept == Approx(1));
    CHECK(exact.slope_error == Approx(0).margin(1e-12));
    // y = (0, 1, 1, 2): slope 0.6, residual sum 0.2, error sqrt(0.2 / 2 / 5).
    const FittedLine rough = fit_line({0, 1, 2, 3}, {0, 1, 1, 2});
    CHECK(rough.slope == Approx(0.6));
    CHECK(rough.slope_error == Approx(std::sqrt(0.02)));
    const FittedLine far = fit_line({1e8, 1e8 + 1, 1e8 + 2}, {5, 8, 11});  // sums of squares would cancel
    CHECK(far.slope == Approx(3));
    const FittedLine two = fit_line({1, 3}, {0, 1});
    CHECK(two.slope == Approx(0.5));
    CHECK(two.slope_error == 0);
    CHECK_THROWS_AS(fit_line({1, 1}, {0, 1}), std::invalid_argument);
    CHECK_THROWS_AS(fit_line({0, 1}, {0}), std::invalid_argument);
    CHECK_THROWS_AS(fit_line({}, {}), std::invalid_argument);
}

TEST_CASE("growth laws are found in the last two octaves, whatever came before") {
    for (const double exponent : {0.5, 1.0, 2.0, 3.0}) {
        std::vector<double> t, y;
        for (int i = 0; i <= 200; ++i) {
            t.push_back(0.1 * i);
            y.push_back(1e-6 * std::pow(t.back(), exponent) * (t.back() < 4.9 ? 3 : 1 + 0.01 * test::noise(i)));
        }
        const auto law = fit_growth(t, y, 1e-12);
        REQUIRE(law);
        CHECK(law->exponent == Approx(exponent).margin(law->spread + 0.005));
        CHECK(law->spread < 0.02);
        CHECK(law->from == Approx(5));
        CHECK(law->to == Approx(20));
        CHECK(law->coefficient == Approx(1e-6).epsilon(0.05));
    }
}

TEST_CASE("no growth law is made up") {
    const std::vector<double> t = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    CHECK(fit_growth(t, {0, 1, 2, 3, 4, 5, 6, 7, 8}, 7));
    CHECK(!fit_growth(t, {0, 1, 2, 3, 4, 5, 6, 7, 8}, 10));  // ends below the level of round-off
    CHECK(!fit_growth(t, std::vector<double>(9, 0.0), 0));
    CHECK(!fit_growth({0, 1, 2}, {1, 2, 3}, 0));
    CHECK(!fit_growth({}, {}, 0));
    std::vector<double> saturating;  // t^2 up to T/2, constant from there on: no power law
    for (const double time : t) { saturating.push_back(std::min(time * time, 16.0)); }
    CHECK(!fit_growth(t, saturating, 0));
}
