// SPDX-License-Identifier: BSD-3-Clause
//
// The extrapolation method itself: exact on polynomials up to its order, observed order, and controls with wrong
// abscissae that the same check rejects.
#include <catch2/catch.hpp>
#include <stdexcept>
#include <vector>

#include "engine/reference/gbs.hpp"
#include "engine/reference/quaternion_form.hpp"
#include "engine/reference/reference.hpp"
#include "tests/engine/named_problem.hpp"

using namespace kreisel;
using namespace reference_tests;

namespace {

/// |w - w_ref| at t = 1 on the acceptance problem, which is state dependent, non-commuting and non-autonomous.
class AcceptanceProblem {
  public:
    AcceptanceProblem() : form_(standard_model("forced_heavy_top")), exact_(run(even_sequence(11), 20)) {}

    Real error(const ExtrapolationTable& table, int steps) {
        const std::vector<Real> w = run(table, steps);
        Real sum = 0;
        for (std::size_t i = 0; i < w.size(); ++i) sum += (w[i] - exact_[i]) * (w[i] - exact_[i]);
        return sqrt(sum);
    }

    /// log2 e_h/e_{h/2} for `levels` halvings.
    std::vector<double> slopes(const ExtrapolationTable& table, int steps, int levels) {
        std::vector<double> result;
        Real before = error(table, steps);
        for (int level = 0; level < levels; ++level) {
            const Real after = error(table, steps *= 2);
            result.push_back(std::log2(to_double(before / after)));
            before = after;
        }
        return result;
    }

  private:
    std::vector<Real> run(const ExtrapolationTable& table, int steps) {
        Extrapolation gbs(table, form_.dimension(),
                          [this](const Real& t, const Real* w, Real* dw) { return form_.rate(t, w, dw); });
        std::vector<Real> w = form_.start();
        for (int n = 0; n < steps; ++n) REQUIRE(gbs.step(Real(n) / steps, Real(1) / steps, w.data()) == Status::ok);
        return w;
    }

    QuaternionForm form_;
    std::vector<Real> exact_;
};

bool has_order(const std::vector<double>& slopes, double order) {
    bool near = true;
    for (const double slope : slopes) near = near && std::abs(slope - order) < 0.1;
    return near;
}

}  // namespace

TEST_CASE("k columns have order 2k on the acceptance problem") {
    AcceptanceProblem problem;
    const struct { int columns, steps; } cases[] = {{1, 512}, {2, 128}, {3, 64}, {4, 64}};
    for (const auto& [columns, steps] : cases) {
        const std::vector<double> slopes = problem.slopes(even_sequence(columns), steps, 3);
        CAPTURE(columns, slopes);
        CHECK(has_order(slopes, 2 * columns));
    }
}

TEST_CASE("control: wrong abscissae lose the order") {
    AcceptanceProblem problem;
    SECTION("extrapolation in h instead of h^2") {
        ExtrapolationTable table = even_sequence(4);
        for (std::size_t i = 0; i < table.steps.size(); ++i) table.abscissae[i] = Real(1) / table.steps[i];
        const std::vector<double> slopes = problem.slopes(table, 64, 3);
        CAPTURE(slopes);
        CHECK_FALSE(has_order(slopes, 8));
    }
    SECTION("one abscissa off by a millionth") {
        ExtrapolationTable table = even_sequence(4);
        table.abscissae[2] *= 1 + Real(1) / 1000000;
        const std::vector<double> slopes = problem.slopes(table, 64, 3);
        CAPTURE(slopes);
        CHECK_FALSE(has_order(slopes, 8));
    }
}

TEST_CASE("polynomials of degree below the order are integrated exactly, the next one is not") {
    for (const int columns : {1, 2, 5, 11})
        for (int degree = 0; degree <= 2 * columns; ++degree) {
            CAPTURE(columns, degree);
            const auto rate = [degree](const Real& t, const Real*, Real* dw) {
                dw[0] = degree + 1;
                for (int i = 0; i < degree; ++i) dw[0] *= t;
                return Status::ok;
            };
            Extrapolation gbs(even_sequence(columns), 1, rate);
            Real w = 0;
            REQUIRE(gbs.step(Real(0), Real(1), &w) == Status::ok);
            const Real error = abs(w - 1);
            if (degree < 2 * columns)
                CHECK(error < 100000 * epsilon);
            else
                CHECK(error > 1000000 * epsilon);
        }
}

TEST_CASE("a failing right-hand side leaves the state as it was") {
    const auto fails = [](const Real& t, const Real*, Real* dw) {
        dw[0] = 1;
        return t > Real(1) / 2 ? Status::singular_kkt : Status::ok;
    };
    Extrapolation gbs(even_sequence(3), 1, fails);
    Real w = 7;
    CHECK(gbs.step(Real(0), Real(1), &w) == Status::singular_kkt);
    CHECK(w == 7);
    CHECK(gbs.step(Real(0), Real(1) / 4, &w) == Status::ok);
    CHECK(abs(w - Real(29) / 4) < 64 * epsilon);

    Extrapolation nan(even_sequence(3), 1, [](const Real&, const Real*, Real* dw) {
        dw[0] = std::numeric_limits<Real>::quiet_NaN();
        return Status::ok;
    });
    w = 7;
    CHECK(nan.step(Real(0), Real(1), &w) == Status::non_finite);
    CHECK(w == 7);
}

TEST_CASE("tables without a row, or with an odd number of substeps, are refused") {
    const auto rate = [](const Real&, const Real*, Real*) { return Status::ok; };
    CHECK_THROWS_AS(Extrapolation(ExtrapolationTable{}, 1, rate), std::invalid_argument);
    CHECK_THROWS_AS(Extrapolation(ExtrapolationTable{{2, 3}, {Real(1) / 4, Real(1) / 9}}, 1, rate),
                    std::invalid_argument);
    CHECK_THROWS_AS(Extrapolation(ExtrapolationTable{{2, 4}, {Real(1) / 4}}, 1, rate), std::invalid_argument);
}
