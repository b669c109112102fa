// SPDX-License-Identifier: BSD-3-Clause
//
// The observed order is right, with a correct window, or there is a reason for its absence.
#include "records/fits/order.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "tests/plots/curves.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace {

const OrderLimits exact{};

void check_order(const ObservedOrder& found, double expected) {
    INFO(found.reason);
    REQUIRE(found.order);
    CHECK(*found.order == Approx(expected).margin(0.1));
    CHECK(found.uncertainty < 0.15);
    CHECK(found.last >= found.first + 3);
    CHECK(found.reason.empty());
}

}  // namespace

TEST_CASE("clean power laws of order 1 to 8 are found with all points above the floors") {
    for (int p = 1; p <= 8; ++p) {
        INFO("order " << p);
        const auto found = observed_order(curve([&](double h, long) { return std::pow(4 * h, p); }, 8, 12), exact);
        check_order(found, p);
        CHECK(found.uncertainty < 1e-9);
        for (std::size_t i = found.first; i <= found.last; ++i) {
            CHECK(found.points[i].error < 1e-2);
            CHECK(found.points[i].error > 100 * 2.2e-16 * std::sqrt(static_cast<double>(found.points[i].steps)));
        }
    }
}

TEST_CASE("orders 1 to 8 are found beside a next term and under round-off") {
    for (int p = 1; p <= 8; ++p) {
        for (const double next : {-3.0, 3.0}) {
            INFO("order " << p << ", next term " << next);
            const long from = p < 4 ? 32 : 8;
            const auto law = [&](double h, long n) {
                return std::abs(std::pow(h, p) * (1 + next * h) * 0.5 + rounding(n));
            };
            const auto points = curve(law, from, p < 4 ? 10 : 14);
            const auto found = observed_order(points, exact);
            if (found.order) {
                CHECK(*found.order == Approx(p).margin(0.15));
            } else {
                CHECK(p > 5);  // such a steep curve has barely four points between ceiling and floor
            }
        }
    }
}

TEST_CASE("a pre-asymptotic hump does not enter the window") {
    for (int p = 1; p <= 5; ++p) {
        INFO("order " << p);
        const auto law = [&](double h, long) {
            return std::pow(h, p) * (1 + 40 * std::exp(-std::pow((h - 0.03) / 0.02, 2)));
        };
        OrderLimits quad;
        quad.epsilon = epsilon_of("quad");
        const auto found = observed_order(curve(law, 16, 12), quad);
        check_order(found, p);
        CHECK(found.points[found.first].h < 0.02);
    }
}

TEST_CASE("errors of the size of the motion are pre-asymptotic") {
    const auto flat = observed_order(curve([](double, long n) { return 1.4 + 0.1 * noise(n); }), exact);
    CHECK(!flat.order);
    CHECK(flat.why == NoOrder::pre_asymptotic);
    const auto slow = observed_order(curve([](double h, long) { return 100 * h; }, 16, 6), exact);
    CHECK(!slow.order);
    CHECK(slow.why == NoOrder::pre_asymptotic);
}

TEST_CASE("too few points, or too few below the ceiling, give no order") {
    for (int levels = 0; levels <= 3; ++levels) {
        const auto found = observed_order(curve([](double h, long) { return h * h; }, 64, levels), exact);
        CHECK(!found.order);
        CHECK(found.why == NoOrder::too_few_points);
    }
    const auto late = observed_order(curve([](double h, long) { return 4 * h; }, 16, 8), exact);
    CHECK(!late.order);
    CHECK(late.why == NoOrder::pre_asymptotic);
}

TEST_CASE("the round-off floor ends the window") {
    for (const int p : {3, 4, 5}) {
        INFO("order " << p);
        const auto law = [&](double h, long n) { return std::pow(h, p) + rounding(n); };
        const auto found = observed_order(curve(law, 8, 16), exact);
        check_order(found, p);
        CHECK(found.points[found.last].error > 1e-13);
        CHECK(!found.stall);
    }
}

TEST_CASE("errors that are round-off at every step size give no order") {
    const auto found = observed_order(curve([](double, long n) { return rounding(n); }), exact);
    CHECK(!found.order);
    CHECK(found.why == NoOrder::round_off);
    const auto growing =
        observed_order(curve([](double, long n) { return 1e-15 * std::sqrt(static_cast<double>(n)); }), exact);
    CHECK(!growing.order);
    CHECK(growing.why == NoOrder::round_off);
}

TEST_CASE("the reference's error is a floor") {
    OrderLimits limits;
    limits.reference_error = 1e-9;
    const auto law = [](double h, long) { return std::abs(std::pow(h, 4) - 1e-9); };
    const auto found = observed_order(curve(law, 4, 12), limits);
    check_order(found, 4);
    CHECK(found.points[found.last].error > 1e-7);
    limits.reference_error = 1e-3;
    const auto none = observed_order(curve(law, 4, 12), limits);
    CHECK(!none.order);
}

TEST_CASE("a plateau just above the stated floor is seen and kept out") {
    const auto law = [](double h, long n) { return std::pow(h, 4) + 3e-13 * (1 + 0.3 * noise(n)); };
    const auto found = observed_order(curve(law, 8, 14), exact);
    check_order(found, 4);
    CHECK(found.points[found.last].error > 100 * 3e-13);
    const auto high = [](double h, long n) { return std::pow(h, 4) + 3e-12 * (1 + 0.3 * noise(n)); };
    const auto told = observed_order(curve(high, 4, 11), exact);
    check_order(told, 4);
    CHECK(told.stall);
    // If the plateau itself is not visible, its onset spoils the finest slopes: no order.
    CHECK(observed_order(curve(high, 4, 8), exact).why == NoOrder::not_settled);
}

TEST_CASE("a plateau far above round-off refutes any order") {
    for (const double level : {1e-5, 1e-7, 1e-9}) {
        INFO("plateau " << level);
        const auto found = observed_order(curve([&](double h, long) { return std::pow(h, 4) + level; }, 8, 14), exact);
        CHECK(!found.order);
    }
}

TEST_CASE("a lower order that shows only late is not hidden by a higher one before") {
    for (const double weight : {1e-4, 1e-6}) {
        INFO("weight of the lower order " << weight);
        const auto law = [&](double h, long) { return std::pow(h, 4) + weight * h * h; };
        const auto all = observed_order(curve(law, 8, 14), exact);
        // The smaller weight shows only just above round-off: too late for an order, early enough to refute 4.
        CHECK(all.order.has_value() == (weight == 1e-4));
        if (all.order) { CHECK(*all.order == Approx(2).margin(0.1)); }
        // Truncated at any level: order 4 is never claimed while the slopes deviate by more than 0.2.
        for (int levels = 4; levels <= 14; ++levels) {
            const auto cut = observed_order(curve(law, 8, levels), exact);
            if (!cut.order) { continue; }
            CHECK(std::abs(*cut.order - cut.slopes.back()) < 0.25);
        }
    }
}

TEST_CASE("a change of sign of the error is a dip, not an order") {
    for (const double zero : {1.0 / 1500, 1.0 / 3000}) {
        INFO("zero at h = " << zero);
        const auto law = [&](double h, long) { return std::abs(h * h * (h - zero)) + 1e-14; };
        const auto at_the_end = observed_order(curve(law, 64, 6), exact);
        if (at_the_end.order) { CHECK(*at_the_end.order == Approx(at_the_end.slopes.back()).margin(0.2)); }
    }
    const auto law = [](double h, long) { return std::abs(h * h * (1 - 100 * h)); };
    const auto behind = observed_order(curve(law, 16, 13), exact);
    check_order(behind, 2);
    CHECK(behind.points[behind.first].h < 0.01);
}

TEST_CASE("errors that are exactly zero give no order and no infinity") {
    const auto zero = observed_order(curve([](double, long) { return 0.0; }), exact);
    CHECK(!zero.order);
    CHECK(zero.why == NoOrder::round_off);
    CHECK(zero.reason == "no error at all");
    const auto some = observed_order(curve([](double h, long n) { return n > 1024 ? 0.0 : std::pow(h, 3); }), exact);
    check_order(some, 3);
    const auto hole = observed_order(curve([](double h, long n) { return n == 2048 ? 0.0 : h * h; }), exact);
    CHECK((!hole.order || hole.points[hole.first].steps > 2048));
}

TEST_CASE("noise of the size of the error gives no order") {
    for (long seed = 1; seed <= 8; ++seed) {
        const auto law = [&](double, long n) { return 1e-5 * (1.5 + noise(n * 31 + seed)); };
        CHECK(!observed_order(curve(law), exact).order);
    }
}

TEST_CASE("errors that grow with refinement give no order") {
    CHECK(!observed_order(curve([](double h, long) { return 1e-8 / h; }), exact).order);
    CHECK(!observed_order(curve([](double h, long) { return 1e-9 * std::exp(0.01 / h); }, 16, 9), exact).order);
}

TEST_CASE("the scale decides what is small") {
    const auto law = [](double h, long) { return 150 * h * h; };
    OrderLimits large;
    large.scale = 150;
    check_order(observed_order(curve(law, 16, 6), large), 2);
    CHECK(!observed_order(curve(law, 16, 6), exact).order);
    OrderLimits tiny;
    tiny.scale = 1e-6;
    CHECK(observed_order(curve(law, 16, 6), tiny).why == NoOrder::pre_asymptotic);
}

TEST_CASE("quad precision detects errors below double") {
    OrderLimits quad;
    quad.epsilon = epsilon_of("quad");
    const auto law = [](double h, long) { return std::pow(h, 8); };
    const auto points = curve(law, 16, 10);
    check_order(observed_order(points, quad), 8);
    CHECK(observed_order(points, quad).last == 8);
    CHECK(!observed_order(curve(law, 64, 10), exact).order);
}

TEST_CASE("other factors than two, and points in any order, give the same order") {
    std::vector<ErrorPoint> points;
    for (const long steps : {100L, 150L, 225L, 400L, 700L, 1000L}) {
        const double h = 1.0 / static_cast<double>(steps);
        points.push_back({steps, h, 3 * std::pow(h, 3)});
    }
    check_order(observed_order(points, exact), 3);
    std::reverse(points.begin(), points.end());
    check_order(observed_order(points, exact), 3);
}

TEST_CASE("input that is not an error curve is refused") {
    CHECK_THROWS_AS(observed_order({{10, 0.1, 1e-3}, {10, 0.1, 1e-3}}, exact), std::invalid_argument);
    CHECK_THROWS_AS(observed_order({{10, 0.1, 1e-3}, {20, 0.1, 1e-3}}, exact), std::invalid_argument);
    CHECK_THROWS_AS(observed_order({{10, 0.1, std::nan("")}}, exact), std::invalid_argument);
    CHECK_THROWS_AS(observed_order({{10, -0.1, 1e-3}}, exact), std::invalid_argument);
    CHECK_THROWS_AS(observed_order({{10, 0.1, -1e-3}}, exact), std::invalid_argument);
}
