// SPDX-License-Identifier: BSD-3-Clause
//
// The rule for declared orders: the rule that certifies a registered method is the one
// that rejects a control.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "methods/contract/description.hpp"
#include "records/fits/order.hpp"

namespace kreisel {

inline bool is_velocity(const std::string& metric) { return metric == "error.velocity" || metric == "error.omega"; }

inline bool is_multiplier(const std::string& metric) { return metric.starts_with("error.multipliers"); }

inline int declared(const Order& order, const std::string& metric) {
    if (is_multiplier(metric)) return order.multipliers;
    return is_velocity(metric) ? order.velocity : order.configuration;
}

/// Above it, double has no three slopes between the pre-asymptotic range and round-off on the acceptance problems.
inline constexpr int highest_order_in_double = 4;

/// Nor has it for Fehlberg's pair of order four, which advances the lower order, and for extrapolations, whose columns
/// lie two orders apart: their leading errors are small, and those of the next order decide until round-off does. Nor
/// for the Gauss method of order four, whose round-off is that of an iteration, and for splittings, which are exact but
/// for the forces.
inline bool is_seen_in_double(const MethodDescription& method) {
    const int p = method.order.configuration;
    return p < highest_order_in_double || (p == highest_order_in_double && !method.is_implicit() && method.stages > 0 &&
                                           (method.estimate == 0 || method.estimate == p));
}

/// How far an observed order may be from the declared one.
inline double order_tolerance(int declared) { return declared < 6 ? 0.1 : 0.2; }

/// Sizes of the quantities on the acceptance problems, for the limits of round-off and of the pre-asymptotic range.
inline double scale_of(const std::string& metric) { return is_multiplier(metric) ? 100 : is_velocity(metric) ? 5 : 1; }

/// The errors of one quantity, and the bound of the reference's own error.
struct OrderCurve {
    std::vector<ErrorPoint> points;
    double reference_error = 0;
};

/// The objection to the declared orders, in words; empty: none. No quantity's finest admissible slope may lie below
/// the declared order by more than 0.1, and each must have an order; if `sharp`, one quantity of configuration
/// and one of velocity level must come within 0.1 of it (a method may converge faster on one problem than its order
/// promises, so this is required of one acceptance problem only).
/// The finest slope and not the mean: on the pendulum some curves approach their order from below, rk4's omega as 3.85,
/// 3.88, 3.93, 3.99, and a mean over the window is still affected by the coarse steps.
inline std::string order_rule(const std::map<std::string, OrderCurve>& curves, const Order& order, bool sharp) {
    double nearest[2] = {1, 1};  // configuration, velocity
    for (const auto& [metric, curve] : curves) {
        const OrderLimits limits{.scale = scale_of(metric), .reference_error = curve.reference_error};
        const ObservedOrder observed = observed_order(curve.points, limits);
        if (!observed.order) return metric + ": " + observed.reason;
        const int p = declared(order, metric);
        const double finest = observed.slopes.at(observed.last - 1);
        if (!(finest >= p - 0.1))
            return metric + ": slope " + std::to_string(finest) + " of order " + std::to_string(p);
        double& best = nearest[is_velocity(metric) ? 1 : 0];
        if (!is_multiplier(metric)) best = std::min(best, std::abs(*observed.order - p));
    }
    if (!sharp || curves.empty()) return "";
    if (!(nearest[0] <= 0.1)) return "no quantity of the configuration shows the declared order";
    return nearest[1] <= 0.1 ? "" : "no velocity shows the declared order";
}

}  // namespace kreisel
