// SPDX-License-Identifier: BSD-3-Clause
//
// Declared order = observed order where double has only round-off: quad runs with errors down to about 1e-25, for
// every registered method. The end time T follows from the order p such that T (T/N)^p is that small at the finest N,
// or as small as quotients over h allow, so that a method of order 1 gets there with 512 steps too; above order 4 with
// 256, which keeps steps of many stages affordable. (Accumulation of errors over long times is tested in double, by
// orders.cpp, up to order 4.)
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "records/fits/order.hpp"
#include "records/json/writer.hpp"
#include "tests/campaign/acceptance.hpp"

using namespace kreisel;
using namespace kreisel::acceptance;

namespace {

constexpr int levels = 5;

long coarsest(int p) { return p <= highest_order_in_double ? 32 : 16; }

/// Velocities follow from positions alone: they have the round-off of places over h, and multipliers that over h^2.
bool has_quotients(const MethodDescription& method) { return method.meets_positions && !method.meets_velocities; }

/// The T with T (T/N)^p = 2^-83 = 1e-25 for the finest N (2^-88 above order 4, where slopes settle later), or a longer
/// one with T (T/N)^p = 2^10 eps N/T: what implicit methods find as a quotient over h, multipliers or velocities, has
/// round-off eps/h, and where the joints leave a subgroup, as on SE3, its error may be no larger than T h^p. That
/// decides at order 1 (T = 6e-9 for 1e-11) and 2 (4e-6 for 5e-7), and is within a factor of 2 of the first T above.
double end_time(int p) {
    const double log_finest = std::log2(static_cast<double>(coarsest(p) << (levels - 1)));
    const double small = (log_finest * p - (p <= highest_order_in_double ? 83 : 88)) / (p + 1);
    const double above_quotients = (log_finest * (p + 1) + 10 + std::log2(epsilon_of("quad"))) / (p + 2);
    return std::exp2(std::max(small, above_quotients));
}

const Reference& reference(const std::string& problem, double t_end) {
    static std::map<std::pair<std::string, double>, Reference> known;
    Reference& found = known[{problem, t_end}];
    if (found.error.empty()) found = engine_binary128().reference(problem, defaults(problem), t_end, {});
    return found;
}

using ErrorCurves = std::map<std::string, std::vector<ErrorPoint>>;

struct Grid {
    double t_end;
    long coarsest;
};

Grid grid(int p) { return {end_time(p), coarsest(p)}; }

/// Empty if the pair does not run.
ErrorCurves measure(const std::string& problem, const std::string& formulation, const MethodDescription& method,
                    const OptionValues& options, const Grid& grid) {
    const double t_end = grid.t_end;
    ErrorCurves curves;
    for (int level = 0; level < levels; ++level) {
        const Cell cell{.problem = problem,
                        .parameters = defaults(problem),
                        .formulation = formulation,
                        .method = method.name,
                        .options = options,
                        .projection = "none",
                        .projection_options = {},
                        .t_end = t_end,
                        .steps = grid.coarsest << level,
                        .samples = 0,
                        .metrics = {"error.*"}};
        if (!engine_binary128().skip_reason(cell).empty()) return {};
        const Outcome outcome = engine_binary128().run(cell, &reference(problem, t_end), {});
        INFO(outcome.detail);
        REQUIRE(outcome.status == "ok");
        for (const auto& [name, error] : outcome.metrics) {
            // Round-off over h^2 leaves them to longer times, where double gets as far (orders.cpp).
            if (is_multiplier(name) && has_quotients(method)) continue;
            curves[name].push_back({cell.steps, t_end / static_cast<double>(cell.steps), error.value});
        }
    }
    return curves;
}

ObservedOrder observed(const std::vector<ErrorPoint>& points, const std::string& metric, const Reference& reference) {
    return observed_order(points, {.epsilon = epsilon_of("quad"),
                                   .scale = scale_of(metric),
                                   .reference_error = reference.error.at(metric).value});
}

/// The least error that double shows at a step. Quotients over h have round-off over h there too: multipliers that are
/// unknowns, and velocities that follow from positions alone.
double floor_in_double(const ErrorPoint& point, const std::string& metric, const MethodDescription& method) {
    const bool quotient =
        is_multiplier(metric) ? method.reports_multipliers : is_velocity(metric) && has_quotients(method);
    const double round_off = epsilon_of("double") * std::sqrt(static_cast<double>(point.steps)) * scale_of(metric);
    return 100 * round_off / (quotient ? point.h : 1);
}

/// The objection to order `p` of a curve of a method of order `order`, or "". Above order 4 a leading constant can be
/// so small that slopes come down to p from above, and then only falling short is one; one curve of each method is to
/// come near.
std::string objection(const std::vector<ErrorPoint>& points, const std::string& metric, const Reference& reference,
                      int p, int order, const MethodDescription& method) {
    const ObservedOrder found = observed(points, metric, reference);
    if (!found.order) return found.reason;
    const bool high = order > highest_order_in_double;  // which double does not show at all
    // Multipliers of a lower order are the largest errors here.
    if (p == order && !high && points.front().error > floor_in_double(points.front(), metric, method))
        return "double gets as far";
    const bool above = high && *found.order > p;
    return above || std::abs(*found.order - p) <= order_tolerance(p) ? ""
                                                                     : "observed order " + std::to_string(*found.order);
}

/// How near the observed orders come to the declared ones.
double nearest(const ErrorCurves& curves, const Reference& reference, const Order& order) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [metric, points] : curves)
        if (const ObservedOrder found = observed(points, metric, reference); found.order)
            least = std::min(least, std::abs(*found.order - declared(order, metric)));
    return least;
}

/// The first objection to the curves of a method. If `sharp`, one of them must come near the declared order.
std::string objection(const ErrorCurves& curves, const Reference& exact, const Order& order,
                      const MethodDescription& method, bool sharp) {
    const int p = order.configuration;
    for (const auto& [metric, points] : curves)
        if (const std::string found = objection(points, metric, exact, declared(order, metric), p, method);
            !found.empty())
            return metric + ": " + found;
    const bool near = curves.empty() || nearest(curves, exact, order) <= order_tolerance(p);
    return near || !sharp ? "" : "no quantity shows the declared order";
}

/// The number of curves. Above order 4, slopes that have not settled may do so with twice as many steps, or at half the
/// time: the leading error of a method of high order can pass near zero at one T (verner9's of omega as SO3-LiePoisson,
/// 8.7 at T = 0.33, 9.0 at 0.15 and 0.6).
int certify(const std::string& problem, const std::string& formulation, const MethodDescription& method,
            const OptionValues& options) {
    const Order order = engine_binary128().method(method.name, options).order;
    const int p = order.configuration;
    INFO(method.name << " " << json_value(options) << " on " << problem << " as " << formulation);
    const Grid standard = grid(p);
    std::vector<Grid> grids = {standard};
    if (p > highest_order_in_double)
        grids.insert(grids.end(), {{standard.t_end, 2 * standard.coarsest}, {standard.t_end / 2, standard.coarsest}});
    ErrorCurves curves;
    std::string found;
    for (const Grid& grid : grids) {
        curves = measure(problem, formulation, method, options, grid);
        found = objection(curves, reference(problem, grid.t_end), order, method, problem == "forced_heavy_top");
        if (found.empty()) break;
    }
    CHECK(found == "");
    return static_cast<int>(curves.size());
}

int certify(const std::string& problem) {
    int seen = 0;
    for (const MethodDescription& method : engine_binary128().methods()) {
        // Their errors of order 2 are brackets, which over so short a time are smaller than those of order 4.
        if (method.name.starts_with("cautionary/")) continue;
        for (const char* formulation : {"SO3", "SO3-LiePoisson", "SO3xR3", "SE3"})
            seen += certify(problem, formulation, method, standard_options(method));
    }
    return seen;
}

}  // namespace

TEST_CASE("declared orders are observed in quad, below the round-off of double", "[campaign]") {
    CHECK(certify("forced_heavy_top") >= 180);
    CHECK(certify("forced_free_body") >= 100);
    CHECK(certify("double_pendulum") >= 130);
}

TEST_CASE("orders declared under other options are observed in quad", "[campaign]") {
    int seen = 0;
    for (const MethodDescription& method : engine_binary128().methods()) {
        // Their iteration in Cayley coordinates does not end there.
        if (method.name == "variational/rattlie" || method.name == "variational/shakelie") continue;
        const auto all = variants(method);
        for (std::size_t i = 1; i < all.size(); ++i) seen += certify("forced_heavy_top", "SO3xR3", method, all[i]);
    }
    CHECK(seen >= 50);
}

TEST_CASE("quad rejects a method that claims one order more", "[campaign][control]") {
    for (const MethodDescription& method : engine_binary128().methods())
        if (method.name == "rkmk/kutta3") {
            const ErrorCurves curves = measure("forced_heavy_top", "SO3xR3", method, standard_options(method), grid(3));
            const Reference& exact = reference("forced_heavy_top", end_time(3));
            CHECK(objection(curves.at("error.rotation"), "error.rotation", exact, 3, 3, method) == "");
            CHECK(objection(curves.at("error.rotation"), "error.rotation", exact, 4, 4, method) != "");
        }
}
