// SPDX-License-Identifier: BSD-3-Clause
//
// Declared order = observed order where double has only round-off: quad runs with errors down to about 1e-25, for
// every registered method. The end time T follows from the order p such that T (T/N)^p is that small at the finest N,
// so that a method of order 1 gets there with a thousand steps too. (Accumulation of errors over long times is tested
// in double, by orders.cpp.)
#include <catch2/catch.hpp>
#include <cmath>

#include "records/fits/order.hpp"
#include "records/json/writer.hpp"
#include "tests/campaign/acceptance.hpp"

using namespace kreisel;
using namespace kreisel::acceptance;

namespace {

constexpr long coarsest = 64;
constexpr int levels = 5;

/// T with T (T/N)^p = 2^-83 = 1e-25 for N = 1024.
double end_time(int p) { return std::exp2(-(83.0 - 10 * p) / (p + 1)); }

const Reference& reference(const std::string& problem, double t_end) {
    static std::map<std::pair<std::string, double>, Reference> known;
    Reference& found = known[{problem, t_end}];
    if (found.error.empty()) found = engine_binary128().reference(problem, defaults(problem), t_end, {});
    return found;
}

using ErrorCurves = std::map<std::string, std::vector<ErrorPoint>>;

/// Empty if the pair does not run.
ErrorCurves measure(const std::string& problem, const std::string& formulation, const MethodDescription& method,
                    const OptionValues& options, double t_end) {
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
                        .steps = coarsest << level,
                        .samples = 0,
                        .metrics = {"error.*"}};
        if (!engine_binary128().skip_reason(cell).empty()) return {};
        const Outcome outcome = engine_binary128().run(cell, &reference(problem, t_end), {});
        INFO(outcome.detail);
        REQUIRE(outcome.status == "ok");
        for (const auto& [name, error] : outcome.metrics)
            curves[name].push_back({cell.steps, t_end / static_cast<double>(cell.steps), error.value});
    }
    return curves;
}

/// The objection to order `p` of a curve, or "".
std::string objection(const std::vector<ErrorPoint>& points, const std::string& metric, const Reference& reference,
                      int p) {
    const OrderLimits limits{
        .epsilon = epsilon_of("quad"), .scale = scale_of(metric), .reference_error = reference.error.at(metric).value};
    const ObservedOrder observed = observed_order(points, limits);
    if (!observed.order) return observed.reason;
    // Multipliers that are unknowns are wrong by h^p, without the factor T: they stay the largest errors here.
    const double floor = 100 * epsilon_of("double") * std::sqrt(static_cast<double>(coarsest)) * limits.scale;
    if (points.front().error > floor) return "double gets as far";
    return std::abs(*observed.order - p) <= 0.1 ? "" : "observed order " + std::to_string(*observed.order);
}

/// The number of curves.
int certify(const std::string& problem, const std::string& formulation, const MethodDescription& method,
            const OptionValues& options) {
    const Order order = engine_binary128().declared_order(method.name, options);
    const double t_end = end_time(order.configuration);
    int seen = 0;
    for (const auto& [metric, points] : measure(problem, formulation, method, options, t_end)) {
        INFO(method.name << " " << json_value(options) << " on " << problem << " as " << formulation << ", " << metric
                         << ", finest error " << points.back().error);
        CHECK(objection(points, metric, reference(problem, t_end), declared(order, metric)) == "");
        ++seen;
    }
    return seen;
}

int certify(const std::string& problem) {
    int seen = 0;
    for (const MethodDescription& method : engine_binary128().methods())
        for (const char* formulation : {"SO3", "SO3xR3", "SE3"})
            seen += certify(problem, formulation, method, standard_options(method));
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
        const auto all = variants(method);
        for (std::size_t i = 1; i < all.size(); ++i) seen += certify("forced_heavy_top", "SO3xR3", method, all[i]);
    }
    CHECK(seen >= 50);
}

TEST_CASE("quad rejects a method that claims one order more", "[campaign][control]") {
    for (const MethodDescription& method : engine_binary128().methods())
        if (method.name == "rkmk/kutta3") {
            const ErrorCurves curves =
                measure("forced_heavy_top", "SO3xR3", method, standard_options(method), end_time(3));
            const Reference& exact = reference("forced_heavy_top", end_time(3));
            CHECK(objection(curves.at("error.rotation"), "error.rotation", exact, 3) == "");
            CHECK(objection(curves.at("error.rotation"), "error.rotation", exact, 4) != "");
        }
}
