// SPDX-License-Identifier: BSD-3-Clause
//
// Paths between their samples.
#include "plots/figures/kinds/smooth_path.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using namespace kreisel;

namespace smooth {

/// `turns` of a unit circle in 1 s, at `samples` + 1 instants.
BodyPath circle(int samples, double turns) {
    BodyPath path;
    const double rate = 2 * std::numbers::pi * turns;
    for (int k = 0; k <= samples; ++k) {
        const double t = static_cast<double>(k) / samples, c = std::cos(rate * t), s = std::sin(rate * t);
        path.t.push_back(t);
        path.x.push_back({c, s, 0});
        path.v.push_back({-rate * s, rate * c, 0});
    }
    return path;
}

}  // namespace smooth

TEST_CASE("a path is smooth between samples where velocities are known") {
    const BodyPath samples = smooth::circle(12, 1), path = smooth_path(samples);
    REQUIRE(path.t.size() == 12 * 5 + 1);  // 30 degrees in steps of 6
    CHECK((path.x.size() == path.t.size() && path.v.size() == path.t.size()));
    for (std::size_t i = 0; i < path.t.size(); ++i) {
        const double angle = 2 * std::numbers::pi * path.t[i];
        CHECK(std::hypot(path.x[i][0] - std::cos(angle), path.x[i][1] - std::sin(angle)) < 3e-4);
        CHECK(std::hypot(path.v[i][0] / (2 * std::numbers::pi) + std::sin(angle),
                         path.v[i][1] / (2 * std::numbers::pi) - std::cos(angle)) < 3e-3);
    }
    for (std::size_t k = 0; k < samples.t.size(); ++k) { CHECK(path.x[5 * k] == samples.x[k]); }
}

TEST_CASE("a path is straight between samples that tell no arc") {
    CHECK(smooth_path(smooth::circle(360, 1)).t.size() == 361);  // as smooth as it is
    CHECK(smooth_path(smooth::circle(12, 11)).t.size() == 13);   // nearly a turn from one sample to the next
    BodyPath unknown = smooth::circle(12, 1);
    unknown.v.clear();
    CHECK(smooth_path(unknown).x == unknown.x);
    BodyPath stopped = smooth::circle(2, 0.4);
    stopped.v[1][0] = std::nan("");
    CHECK(smooth_path(stopped).x == stopped.x);
}
