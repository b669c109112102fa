// SPDX-License-Identifier: GPL-3.0-or-later
//
// Declared order = observed order, for every registered method up to order four with no further line written: double
// runs against quad references on the acceptance problems, judged by the rule of records/fits/order.hpp. (All orders in
// quad: quad_orders.cpp.) It uses the GNU Scientific Library.
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/engine.hpp"
#include "tests/campaign/acceptance.hpp"

using namespace kreisel;
using namespace kreisel::acceptance;

namespace {

const Engine& engine() { return engine_binary64(); }

const Reference& reference(const std::string& problem) {
    static std::map<std::string, Reference> known;
    if (!known.contains(problem)) known[problem] = engine_binary128().reference(problem, defaults(problem), 1.0, {});
    return known.at(problem);
}

using Curves = std::map<std::string, OrderCurve>;

Curves measure(const std::string& problem, const std::string& formulation, const MethodDescription& method,
               const OptionValues& options, long from, int levels) {
    Curves curves;
    for (int level = 0; level < levels; ++level) {
        Cell cell{.problem = problem,
                  .parameters = defaults(problem),
                  .formulation = formulation,
                  .method = method.name,
                  .options = options,
                  .projection = "none",
                  .projection_options = {},
                  .t_end = 1,
                  .steps = from << level,
                  .samples = 0,
                  .metrics = {"error.*"}};
        if (!engine().skip_reason(cell).empty()) return {};
        const Outcome outcome = engine().run(cell, &reference(problem), {});
        INFO(outcome.detail);
        REQUIRE(outcome.status == "ok");
        for (const auto& [name, error] : outcome.metrics) {
            OrderCurve& curve = curves[name];
            curve.points.push_back({cell.steps, 1.0 / static_cast<double>(cell.steps), error.value});
            curve.reference_error = reference(problem).error.at(name).value;
        }
    }
    return curves;
}

/// Of J_O = J + m (|c|^2 I - c c^T), the inertia about the fixed point (2-norm); 1 where there is none.
double condition_about_pivot(const ParameterValues& parameters) {
    if (!parameters.contains("lever")) return 1;
    const auto& c = std::get<Vector3>(parameters.at("lever"));
    auto J_O = std::get<Matrix3>(parameters.at("inertia"));
    const double m = std::get<double>(parameters.at("mass"));
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) J_O[3 * i + k] -= m * c[i] * c[k];
        J_O[4 * i] += m * (c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
    }
    gsl_matrix_view matrix = gsl_matrix_view_array(J_O.data(), 3, 3);
    double moments[3];
    gsl_vector_view values = gsl_vector_view_array(moments, 3);
    gsl_eigen_symm_workspace* workspace = gsl_eigen_symm_alloc(3);
    REQUIRE(gsl_eigen_symm(&matrix.matrix, &values.vector, workspace) == GSL_SUCCESS);
    gsl_eigen_symm_free(workspace);
    const auto [least, most] = std::minmax_element(moments, moments + 3);
    return *most / *least;
}

/// Errors below the limit of round-off of a quantity of a larger scale: omega is J_O^{-1} m, so that its round-off is
/// larger by the condition of J_O.
void leave_out_round_off(OrderCurve& curve, double scale) {
    std::erase_if(curve.points, [&](const ErrorPoint& point) {
        return point.error < 100 * epsilon_of("double") * std::sqrt(static_cast<double>(point.steps)) * scale;
    });
}

/// The rule of tests/support/order_rule.hpp, for every method, every variant and every formulation that takes them.
void certify(const std::string& problem, bool sharp, long from) {
    const double condition = condition_about_pivot(defaults(problem));
    for (const MethodDescription& method : engine().methods()) {
        if (!is_seen_in_double(method)) continue;
        for (const OptionValues& options : variants(method))
            for (const char* formulation : {"SO3", "SO3-LiePoisson", "SO3xR3", "SE3"}) {
                const bool first_order = method.order.configuration == 1;
                // Multipliers of order 1 of a method of order 2 need shorter steps to settle, and so do the errors of
                // Cayley coordinates of SE(3), which start at 1.4 rad/s on the pendulum and fall by 4 only.
                const bool slow = method.order.multipliers == 1 || options.contains("coordinates");
                // Brackets of T*SO(3) have the momentum about the pivot: their errors settle later, those of low order
                // by three octaves.
                const bool brackets = formulation == std::string("SO3-LiePoisson");
                // Other options are checked step by step (tests/orders), order 4 in quad: above the round-off there are
                // not enough slopes here.
                if (brackets &&
                    (options != variants(method).front() || method.order.configuration >= highest_order_in_double))
                    continue;
                const int later = !brackets ? 0 : method.order.configuration > 2 ? 1 : 3;
                const int levels = later + (first_order ? 7 : slow && method.order.configuration == 2 ? 8 : 6);
                Curves curves = measure(problem, formulation, method, options, first_order ? 64 * from : from, levels);
                if (brackets && !curves.empty())
                    for (const char* metric : {"error.rotation", "error.omega"})
                        leave_out_round_off(curves[metric], scale_of(metric) * condition);
                // Multipliers of the index-3 form have the round-off of places over h^2.
                if (method.meets_positions && !method.meets_velocities)
                    for (auto& [metric, curve] : curves)
                        if (is_multiplier(metric)) curve.points.pop_back();
                INFO(method.name << " on " << problem << " as " << formulation);
                CHECK(order_rule(curves, method.order, sharp) == "");
            }
    }
}

}  // namespace

TEST_CASE("declared orders are observed on the forced heavy top", "[campaign]") {
    certify("forced_heavy_top", true, 64);
}

TEST_CASE("declared orders are observed on the forced free body", "[campaign]") {
    certify("forced_free_body", true, 64);
}

TEST_CASE("no method falls below its order on the double pendulum", "[campaign]") {
    certify("double_pendulum", false, 128);
}

TEST_CASE("the certification rejects a method that claims one order more", "[campaign][control]") {
    for (const MethodDescription& method : engine().methods())
        if (method.name == "rkmk/kutta3") {
            const Curves curves = measure("forced_heavy_top", "SO3xR3", method, variants(method)[0], 64, 6);
            CHECK(order_rule(curves, method.order, true) == "");
            CHECK(order_rule(curves, Order(4), false) != "");
        }
}

TEST_CASE("the truncated dexpinv has the order its number of brackets allows", "[campaign]") {
    // q brackets give order q + 2, up to the order of the tableau: rk4 has 2, 3, 4, 4 for q = 0, 1, 2, 4.
    const int expected[][2] = {{0, 2}, {1, 3}, {2, 4}, {4, 4}};
    for (const MethodDescription& method : engine().methods())
        if (method.name == "rkmk/rk4")
            for (const auto& [q, order] : expected) {
                OptionValues options = variants(method)[0];
                options["dexpinv"] = static_cast<long>(q);
                const Curves curves = measure("forced_heavy_top", "SO3", method, options, 64, 6);
                const ObservedOrder observed = observed_order(curves.at("error.rotation").points, {});
                INFO("q = " << q << ": " << observed.reason);
                REQUIRE(observed.order);
                CHECK(*observed.order == Approx(order).margin(0.12));
            }
}

TEST_CASE("double and quad runs of one cell agree to double round-off", "[campaign]") {
    for (const MethodDescription& method : engine().methods()) {
        if (method.own_control) continue;
        Cell cell{.problem = "forced_heavy_top",
                  .parameters = defaults("forced_heavy_top"),
                  .formulation = "SO3",
                  .method = method.name,
                  .options = variants(method)[0],
                  .projection = "none",
                  .projection_options = {},
                  .t_end = 1,
                  .steps = 64,
                  .samples = 0,
                  .metrics = {}};
        if (!engine_binary64().skip_reason(cell).empty()) continue;
        const Outcome narrow = engine_binary64().run(cell, nullptr, {}),
                      wide = engine_binary128().run(cell, nullptr, {});
        INFO(method.name);
        REQUIRE(narrow.status == "ok");
        REQUIRE(wide.status == "ok");
        for (std::size_t i = 0; i < 9; ++i)
            CHECK(std::abs(narrow.final->bodies[0].R[i].value - wide.final->bodies[0].R[i].value) <= 1e-12);
    }
}
