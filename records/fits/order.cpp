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

double round_off(const ErrorPoint& point, const OrderLimits& limits) {
    return limits.epsilon * std::sqrt(static_cast<double>(point.steps)) * limits.scale;
}

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

// Finds the rule's window step by step.
class Search {
  public:
    Search(ObservedOrder& result, const OrderLimits& limits) : result_(result), limits_(limits) {}

    void run() {
        if (result_.points.size() < least_slopes + 1) {
            return none(NoOrder::too_few_points, fmt::format("{} step sizes, 4 are needed", result_.points.size()));
        }
        find_stall();
        if (result_.why != NoOrder::none || !find_finest()) { return; }
        extend_to_coarser();
    }

  private:
    const std::vector<ErrorPoint>& points() const { return result_.points; }

    void none(NoOrder why, std::string reason) {
        result_.why = why;
        result_.reason = std::move(reason);
    }

    double floor(std::size_t i) const {
        return floor_factor * std::max({limits_.reference_error, round_off(points()[i], limits_), stall_});
    }
    bool above_floor(std::size_t i) const { return points()[i].error > floor(i); }
    bool admissible(std::size_t i) const { return above_floor(i) && points()[i].error < ceiling * limits_.scale; }

    // The coarsest point from which errors of similar size (noise within a factor 100) fall with slope below 1/2 on the
    // whole; the finest point if there is no such plateau.
    std::size_t plateau_begin() const {
        constexpr double one_size = 100;
        const ErrorPoint& finest = points().back();
        double least = finest.error, most = finest.error;
        std::size_t first = points().size() - 1;
        for (std::size_t i = points().size() - 1; i-- > 0;) {
            least = std::min(least, points()[i].error);
            most = std::max(most, points()[i].error);
            if (!(most < one_size * least)) { break; }
            if (slope_between(points()[i], finest) < no_convergence) { first = i; }
        }
        return first;
    }

    // Finest errors that no longer decrease form a plateau, whatever the stated floors.
    void find_stall() {
        const std::size_t n = points().size(), first = plateau_begin();
        if (first == n - 1) { return; }
        std::vector<double> errors;
        for (std::size_t i = first; i < n; ++i) { errors.push_back(points()[i].error); }
        std::sort(errors.begin(), errors.end());
        const double level = errors[(errors.size() - 1) / 2];  // median: the ends may be outliers
        if (level >= ceiling * limits_.scale) { return; }
        if (above_floor(n - 1)) { result_.stall = level; }
        const bool explained = level <= stall_factor * round_off(points()[n - 1], limits_) ||
                               level <= floor_factor * limits_.reference_error;
        if (!explained) {
            return none(NoOrder::not_convergent,
                        fmt::format("the error stops falling at {:.1e}, far above round-off", level));
        }
        stall_ = level;
    }

    // The run of admissible points that ends at the finest one; its three finest slopes must agree.
    bool find_finest() {
        std::size_t end = points().size();
        while (end > 0 && !admissible(end - 1)) { --end; }
        if (end == 0) {
            no_admissible_point();
            return false;
        }
        result_.last = end - 1;
        std::size_t begin = result_.last;
        while (begin > 0 && admissible(begin - 1)) { --begin; }
        earliest_ = begin;
        if (result_.last - begin < least_slopes) {
            too_short(begin);
            return false;
        }
        result_.first = result_.last - least_slopes;
        return finest_agree();
    }

    void no_admissible_point() {
        const bool all_low = !above_floor(0);
        const bool exact = points().front().error == 0 && points().back().error == 0;
        if (exact) {
            none(NoOrder::round_off, "no error at all");
        } else if (all_low) {
            none(NoOrder::round_off, "at the floor of round-off or reference at every step size");
        } else if (above_floor(points().size() - 1)) {
            none(NoOrder::pre_asymptotic, "pre-asymptotic: no error below 1e-2 of the scale");
        } else {
            none(NoOrder::too_few_points, "the errors leap from above 1e-2 of the scale to the floor");
        }
    }

    void too_short(std::size_t begin) {
        const std::size_t count = result_.last - begin + 1;
        const bool floor_cuts = result_.last + 1 < points().size();
        const char* cut = floor_cuts ? "the finer ones are at the floor" : "the coarser ones are pre-asymptotic";
        none(floor_cuts ? NoOrder::round_off : NoOrder::pre_asymptotic,
             fmt::format("only {} consecutive admissible step sizes, 4 are needed: {}", count, cut));
    }

    bool finest_agree() {
        const double* s = result_.slopes.data() + result_.first;
        const auto [low, high] = std::minmax_element(s, s + least_slopes);
        const double tolerance = std::max(0.2, 0.05 * std::abs(s[2]));
        const double change = std::abs(s[2] - s[1]), before = std::abs(s[1] - s[0]);
        const bool diverging = change > steady && change > before;
        if (*high - *low > tolerance || diverging) {
            none(NoOrder::not_settled,
                 fmt::format("not settled: the finest slopes are {:.2f}, {:.2f}, {:.2f}", s[0], s[1], s[2]));
            return false;
        }
        if (*low < no_convergence) {
            none(NoOrder::not_convergent,
                 fmt::format("no convergence: the finest slopes are {:.2f}, {:.2f}, {:.2f}", s[0], s[1], s[2]));
            return false;
        }
        return true;
    }

    void extend_to_coarser() {
        constexpr double spread = 0.1;
        auto [low, high] = std::minmax_element(result_.slopes.begin() + static_cast<std::ptrdiff_t>(result_.first),
                                               result_.slopes.begin() + static_cast<std::ptrdiff_t>(result_.last));
        double least = *low, most = *high;
        while (result_.first > earliest_) {
            const double next = result_.slopes[result_.first - 1];
            least = std::min(least, next);
            most = std::max(most, next);
            if (most - least > spread) { break; }
            --result_.first;
        }
        fit();
    }

    void fit() {
        std::vector<double> x, y;
        for (std::size_t i = result_.first; i <= result_.last; ++i) {
            x.push_back(std::log(points()[i].h));
            y.push_back(std::log(points()[i].error));
        }
        result_.order = fit_line(x, y).slope;
        for (std::size_t i = result_.first; i < result_.last; ++i) {
            result_.uncertainty = std::max(result_.uncertainty, std::abs(result_.slopes[i] - *result_.order));
        }
    }

    ObservedOrder& result_;
    const OrderLimits& limits_;
    double stall_ = 0;
    std::size_t earliest_ = 0;
};

}  // namespace

ObservedOrder observed_order(std::vector<ErrorPoint> points, const OrderLimits& limits) {
    std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.steps < b.steps; });
    check(points);
    ObservedOrder result;
    result.points = std::move(points);
    for (std::size_t i = 0; i + 1 < result.points.size(); ++i) {
        result.slopes.push_back(slope_between(result.points[i], result.points[i + 1]));
    }
    Search(result, limits).run();
    return result;
}

double epsilon_of(const std::string& precision) {
    return precision == "quad" ? std::ldexp(1.0, -112) : std::numeric_limits<double>::epsilon();
}

}  // namespace kreisel
