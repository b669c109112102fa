// SPDX-License-Identifier: BSD-3-Clause
//
// Synthetic error curves with known answers.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "records/fits/order.hpp"

namespace kreisel::test {

using ErrorLaw = std::function<double(double h, long steps)>;

/// Errors e(h, N) over t in [0, 1] at N = from 2^k, k = 0 ... levels - 1.
inline std::vector<ErrorPoint> curve(const ErrorLaw& error, long from = 16, int levels = 10) {
    std::vector<ErrorPoint> points;
    for (long steps = from; levels > 0; --levels, steps *= 2) {
        const double h = 1.0 / static_cast<double>(steps);
        points.push_back({steps, h, error(h, steps)});
    }
    return points;
}

/// A reproducible number in [-1, 1] (splitmix64 of `seed`): round-off without a random generator's state.
inline double noise(long seed) {
    auto z = static_cast<unsigned long long>(seed) * 0x9E3779B97F4A7C15ULL;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return static_cast<double>((z ^ (z >> 31U)) >> 11U) / 4503599627370496.0 - 1;
}

/// Round-off as long integrations show it: a few eps sqrt(N).
inline double rounding(long steps, double size = 1) {
    return size * 2.2e-16 * std::sqrt(static_cast<double>(steps)) * (2 + noise(steps));
}

}  // namespace kreisel::test
