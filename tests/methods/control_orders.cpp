// SPDX-License-Identifier: BSD-3-Clause
//
// The acceptance problem refutes methods that are broken on purpose: their observed order is the lower one they have,
// while the sound ones pass the same judgement.
#include "tests/controls/controls.hpp"

#include "experiments/engine/reference.hpp"
#include "tests/methods/stepping.hpp"

using namespace kreisel;
using namespace models;
using namespace stepping;

#if !KREISEL_QUAD

namespace {

/// Slope of the rotation error between N and 2N steps on the forced heavy top, t = 1 s.
double observed_slope(const Method& entry, const OptionValues& options, long steps) {
    static const ReferenceSolution exact = reference_solution(standard("forced_heavy_top"), 1);
    double errors[2];
    for (int i = 0; i < 2; ++i) {
        Trip trip(standard("forced_heavy_top"), "SO3xR3", entry, options);
        REQUIRE(trip.run(1, steps << i) == Status::ok);
        errors[i] = to_double(distance(trip.bodies(), exact.states).rotation);
    }
    return std::log2(errors[0] / errors[1]);
}

}  // namespace

TEST_CASE("controls show the order they have, not the one they claim", "[methods][control]") {
    for (const Control& control : controls()) {
        const double slope = observed_slope(control.method, {}, 512);
        INFO(control.method.description.name);
        CHECK(slope == Approx(control.true_order).margin(0.15));
    }
}

TEST_CASE("sound methods pass the judgement that turns controls down", "[methods]") {
    for (const Method& entry : methods()) {
        const int p = entry.description.order.configuration;
        const double slope = observed_slope(entry, default_options(entry.description.options), p == 1 ? 16384 : 512);
        INFO(entry.description.name);
        CHECK(slope == Approx(p).margin(0.15));
    }
}

#endif
