// SPDX-License-Identifier: BSD-3-Clause
#include "records/fits/order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "records/fits/fit.hpp"

namespace kreisel {

namespace {

constexpr double floor_factor = 100;    // an error 100 floors high shifts a local slope by 0.015 at most
constexpr double ceiling = 1e-2;        // relative to the scale
constexpr double stall_factor = 1e4;    // highest plateau that counts as round-off, in epsilon sqrt(N) scale
constexpr double no_convergence = 0.5;  // below this slope an error does not decrease
constexpr double steady = 0.1;          // a last change of slope that needs no smaller one before it
constexpr std::size_t least_slopes = 3;

void check(const std::vector<ErrorPoint>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool good = points[i].steps > 0 && points[i].h > 0 && std::isfinite(points[i].h) && points[i].error >= 0;
        if (!good) { throw std::invalid_argument("observed_order: steps, h and error must be positive and finite"); }
        if (i > 0 && (points[i - 1].steps == points[i].steps || points[i - 1].h <= points[i].h)) {
            throw std::invalid_argument("observed_order: each number of steps once, and h must fall with it");
        }
    }
}

double slope_between(const ErrorPoint& coarse, const ErrorPoint& fine) {
    if (coarse.error <= 0 || fine.error <= 0) { return std::numeric_limits<double>::quiet_NaN(); }
    return std::log(coarse.error / fine.error) / std::log(coarse.h / fine.h);
}

// States why there is no order; false, for the caller to return.
bool refuse(ObservedOrder& result, NoOrder why, std::string reason) {
    result.why = why;
    result.reason = std::move(reason);
    return false;
}

// The bounds between which an error is due to the method only.
struct Bounds {
    const OrderLimits& limits;
    double plateau = 0;  // level at which the finest errors stay

    double round_off(const ErrorPoint& point) const {
        return limits.epsilon * std::sqrt(static_cast<double>(point.steps)) * limits.scale;
    }
    bool above_floor(const ErrorPoint& point) const {
        return point.error > floor_factor * std::max({limits.reference_error, round_off(point), plateau});
    }
    bool below_ceiling(double error) const { return error < ceiling * limits.scale; }
};

bool admissible(const ErrorPoint& point, const Bounds& bounds) {
    return bounds.above_floor(point) && bounds.below_ceiling(point.error);
}

// The coarsest point from which errors of similar size (noise within a factor 100) fall with slope below 1/2 on the
// whole; the finest point if there is no such plateau.
std::size_t plateau_begin(const std::vector<ErrorPoint>& points) {
    constexpr double one_size = 100;
    const ErrorPoint& finest = points.back();
    double least = finest.error, most = finest.error;
    std::size_t first = points.size() - 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) {
        least = std::min(least, points[i].error);
        most = std::max(most, points[i].error);
        if (!(most < one_size * least)) { break; }
        if (slope_between(points[i], finest) < no_convergence) { first = i; }
    }
    return first;
}

// The median of the errors from `first` on: the ends of a plateau may be outliers.
double level_from(const std::vector<ErrorPoint>& points, std::size_t first) {
    std::vector<double> errors;
    for (std::size_t i = first; i < points.size(); ++i) { errors.push_back(points[i].error); }
    std::sort(errors.begin(), errors.end());
    return errors[(errors.size() - 1) / 2];
}

// Finest errors that no longer decrease form a plateau, whatever the stated floors: a floor of its own. False, with the
// reason, if neither round-off nor the reference explains it.
bool plateau(ObservedOrder& result, Bounds& bounds) {
    const ErrorPoint& finest = result.points.back();
    const std::size_t first = plateau_begin(result.points);
    if (first == result.points.size() - 1) { return true; }
    const double level = level_from(result.points, first);
    if (!bounds.below_ceiling(level)) { return true; }
    if (bounds.above_floor(finest)) { result.stall = level; }
    const bool explained =
        level <= stall_factor * bounds.round_off(finest) || level <= floor_factor * bounds.limits.reference_error;
    if (!explained) {
        return refuse(result, NoOrder::not_convergent,
                      fmt::format("the error stops falling at {:.1e}, far above round-off", level));
    }
    bounds.plateau = level;
    return true;
}

bool no_admissible_point(ObservedOrder& result, const Bounds& bounds) {
    const ErrorPoint &coarsest = result.points.front(), &finest = result.points.back();
    if (coarsest.error == 0 && finest.error == 0) { return refuse(result, NoOrder::round_off, "no error at all"); }
    if (!bounds.above_floor(coarsest)) {
        return refuse(result, NoOrder::round_off, "at the floor of round-off or reference at every step size");
    }
    if (bounds.above_floor(finest)) {
        return refuse(result, NoOrder::pre_asymptotic, "pre-asymptotic: no error below 1e-2 of the scale");
    }
    return refuse(result, NoOrder::too_few_points, "the errors leap from above 1e-2 of the scale to the floor");
}

bool too_short(ObservedOrder& result, std::size_t begin) {
    const bool floor_cuts = result.last + 1 < result.points.size();
    const char* cut = floor_cuts ? "the finer ones are at the floor" : "the coarser ones are pre-asymptotic";
    return refuse(result, floor_cuts ? NoOrder::round_off : NoOrder::pre_asymptotic,
                  fmt::format("only {} consecutive admissible step sizes, {} are needed: {}", result.last - begin + 1,
                              least_slopes + 1, cut));
}

// The three finest slopes must agree, and belong to errors that decrease.
bool finest_agree(ObservedOrder& result) {
    const double* s = result.slopes.data() + result.first;
    const auto [low, high] = std::minmax_element(s, s + least_slopes);
    const double tolerance = std::max(0.2, 0.05 * std::abs(s[2]));
    const double change = std::abs(s[2] - s[1]), before = std::abs(s[1] - s[0]);
    const bool diverging = change > steady && change > before;
    const std::string slopes = fmt::format("the finest slopes are {:.2f}, {:.2f}, {:.2f}", s[0], s[1], s[2]);
    if (*high - *low > tolerance || diverging) {
        return refuse(result, NoOrder::not_settled, "not settled: " + slopes);
    }
    return *low < no_convergence ? refuse(result, NoOrder::not_convergent, "no convergence: " + slopes) : true;
}

// Lets coarser points, down to `earliest`, join the window as long as all slopes stay close together.
void extend(ObservedOrder& result, std::size_t earliest) {
    constexpr double spread = 0.1;
    const auto slope = [&](std::size_t i) { return result.slopes.begin() + static_cast<std::ptrdiff_t>(i); };
    const auto [low, high] = std::minmax_element(slope(result.first), slope(result.last));
    double least = *low, most = *high;
    while (result.first > earliest) {
        const double next = result.slopes[result.first - 1];
        least = std::min(least, next);
        most = std::max(most, next);
        if (most - least > spread) { break; }
        --result.first;
    }
}

// The points from `first` to `last`: those of the run of admissible points that ends at the finest one.
bool window(ObservedOrder& result, const Bounds& bounds) {
    std::size_t end = result.points.size();
    while (end > 0 && !admissible(result.points[end - 1], bounds)) { --end; }
    if (end == 0) { return no_admissible_point(result, bounds); }
    result.last = end - 1;
    std::size_t begin = result.last;
    while (begin > 0 && admissible(result.points[begin - 1], bounds)) { --begin; }
    if (result.last - begin < least_slopes) { return too_short(result, begin); }
    result.first = result.last - least_slopes;
    if (!finest_agree(result)) { return false; }
    extend(result, begin);
    return true;
}

void fit(ObservedOrder& result) {
    std::vector<double> x, y;
    for (std::size_t i = result.first; i <= result.last; ++i) {
        x.push_back(std::log(result.points[i].h));
        y.push_back(std::log(result.points[i].error));
    }
    result.order = fit_line(x, y).slope;
    for (std::size_t i = result.first; i < result.last; ++i) {
        result.uncertainty = std::max(result.uncertainty, std::abs(result.slopes[i] - *result.order));
    }
}

void apply_rule(ObservedOrder& result, const OrderLimits& limits) {
    if (result.points.size() < least_slopes + 1) {
        refuse(result, NoOrder::too_few_points,
               fmt::format("{} step sizes, {} are needed", result.points.size(), least_slopes + 1));
        return;
    }
    Bounds bounds{limits};
    if (plateau(result, bounds) && window(result, bounds)) { fit(result); }
}

}  // namespace

ObservedOrder observed_order(std::vector<ErrorPoint> points, const OrderLimits& limits) {
    std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.steps < b.steps; });
    check(points);
    ObservedOrder result;
    result.points = std::move(points);
    for (std::size_t i = 0; i + 1 < result.points.size(); ++i) {
        result.slopes.push_back(slope_between(result.points[i], result.points[i + 1]));
    }
    apply_rule(result, limits);
    return result;
}

double epsilon_of(const std::string& precision) {
    return precision == "quad" ? std::ldexp(1.0, -112) : std::numeric_limits<double>::epsilon();
}

}  // namespace kreisel
