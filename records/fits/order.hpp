// SPDX-License-Identifier: BSD-3-Clause
//
// The observed order of convergence, with the window that supports it, or the reason why there is none.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace kreisel {

/// The error of one run: `steps` N and step size h (s); `error` in the unit of its metric.
struct ErrorPoint {
    long steps = 0;
    double h = 0;
    double error = 0;
};

/// Bounds of the range in which an error is due to the method only.
struct OrderLimits {
    double epsilon = 2.220446049250313e-16;  ///< unit round-off of the arithmetic (spacing at 1)
    double scale = 1;                        ///< size of the quantity, in the unit of the error
    double reference_error = 0;              ///< error bound of the reference, same unit
};

/// Why no order is stated.
enum class NoOrder { none, too_few_points, round_off, pre_asymptotic, not_settled, not_convergent };

struct ObservedOrder {
    std::optional<double> order;      ///< least-squares slope of log e against log h over the window
    double uncertainty = 0;           ///< largest distance of a local slope of the window from `order`
    std::size_t first = 0, last = 0;  ///< the window: indices into `points`
    std::vector<ErrorPoint> points;   ///< by ascending number of steps
    std::vector<double> slopes;       ///< slopes[i] = log(e_i/e_{i+1}) / log(h_i/h_{i+1}); NaN where an error is zero
    std::optional<double> stall;      ///< error level at which convergence stops, above the stated floors
    NoOrder why = NoOrder::none;
    std::string reason;  ///< `why` in words; empty where an order is stated
};

/// Observed order by a fixed rule. A point is admissible if its error lies below 1e-2 scale, above 100 times the
/// reference's error, above 100 epsilon sqrt(N) scale, and, where the finest errors no longer fall, above 100 times
/// that plateau; the plateau counts as round-off up to 1e4 epsilon sqrt(N) scale only. The window ends at the finest
/// admissible point (the claim is about h -> 0) and has at least three consecutive slopes. The three finest must agree
/// within max(0.2, 5 %), without diverging (the last change at most 0.1 or at most the one before); coarser
/// points join as long as all slopes stay within 0.1. Below slope 1/2 no order is stated.
/// Throws std::invalid_argument on a repeated number of steps, on a step size that is not positive and not decreasing.
ObservedOrder observed_order(std::vector<ErrorPoint> points, const OrderLimits& limits);

/// Unit round-off of a precision by its name in a config: "double" or "quad".
double epsilon_of(const std::string& precision);

}  // namespace kreisel
