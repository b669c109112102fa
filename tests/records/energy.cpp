// SPDX-License-Identifier: BSD-3-Clause
//
// The law of energy errors, of series whose law is known.
#include "records/fits/energy.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <stdexcept>

#include "tests/plots/curves.hpp"

using namespace kreisel;

namespace {

constexpr int samples_of_series = 1000;

// An oscillation of size h^2 and, on top of it, what `secular` says of t and h; |E_0| = 1.
template <class F>
EnergySeries energy_series_of(double h, F secular) {
    EnergySeries series{.h = h, .t = {}, .drift = {}, .scale = 1};
    for (int i = 0; i <= samples_of_series; ++i) {
        const double t = 0.2 * i, noise = 1e-3 * h * h * test::noise(i);
        series.t.push_back(t);
        series.drift.push_back(h * h * (std::cos(1.7 * t) - 1) + noise + secular(t, h));
        series.largest = std::max(series.largest, std::abs(series.drift.back()));
    }
    return series;
}

template <class F>
EnergyLaw law_of_energy(F secular) {
    return energy_law({energy_series_of(0.01, secular), energy_series_of(0.02, secular)});
}

}  // namespace

TEST_CASE("an energy error that oscillates is bounded, with its power of h") {
    const EnergyLaw law = law_of_energy([](double, double) { return 0.0; });
    CHECK(law.verdict == EnergyVerdict::bounded);
    REQUIRE(law.order);
    CHECK(*law.order == Approx(2).margin(0.01));
    CHECK(energy_text(law) == "bounded, h^2.00");
    REQUIRE(law.trends.size() == 2);
    CHECK(law.trends[0].h == 0.02);
}

TEST_CASE("a slow period in the oscillation is not a trend") {
    const EnergyLaw law = law_of_energy([](double t, double h) { return h * h * std::sin(0.09 * t + 1); });
    CHECK(law.verdict == EnergyVerdict::bounded);
}

TEST_CASE("an energy error that grows is found below its oscillation") {
    const EnergyLaw linear = law_of_energy([](double t, double h) { return -h * h * h * t; });
    CHECK(linear.verdict == EnergyVerdict::linear);
    CHECK(*linear.exponent == Approx(1).margin(0.05));
    CHECK(*linear.order == Approx(3).margin(0.05));
    CHECK(energy_text(linear).starts_with("linear, h^"));
    const EnergyLaw square = law_of_energy([](double t, double h) { return std::pow(h, 4) * 10 * t * t; });
    CHECK(square.verdict == EnergyVerdict::growing);
    CHECK(*square.exponent == Approx(2).margin(0.05));
    CHECK(*square.order == Approx(4).margin(0.05));
    CHECK(energy_text(square).starts_with("t^2.0"));
}

TEST_CASE("round-off is neither an energy error nor a trend") {
    const auto round_off = [](double h) {
        EnergySeries series = energy_series_of(h, [](double, double) { return 0.0; });
        series.largest = 0;
        for (std::size_t i = 0; i < series.t.size(); ++i) {
            series.drift[i] = 2e-16 / h * series.t[i];  // one unit in each step, always in the same direction
            series.largest = std::max(series.largest, series.drift[i]);
        }
        return series;
    };
    CHECK(energy_law({round_off(0.01), round_off(0.02)}).verdict == EnergyVerdict::kept);
    CHECK(energy_trend(round_off(0.01)).is_zero());
}

TEST_CASE("a trend at one step size only, or one step size, is not a law") {
    const auto flat = [](double, double) { return 0.0; };
    const auto rising = [](double t, double h) { return h * t; };
    const EnergyLaw mixed = energy_law({energy_series_of(0.01, flat), energy_series_of(0.02, rising)});
    CHECK(mixed.verdict == EnergyVerdict::unclear);
    CHECK(energy_text(mixed) == "unclear");
    CHECK(energy_law({energy_series_of(0.01, flat)}).verdict == EnergyVerdict::unclear);
    CHECK(energy_law({}).verdict == EnergyVerdict::unclear);
    CHECK_THROWS_AS(energy_trend({.h = 0.1, .t = {0, 1}, .drift = {0, 0}}), std::invalid_argument);
}
