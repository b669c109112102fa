// SPDX-License-Identifier: BSD-3-Clause
//
// The small-angle functions against 113-bit sums of their Taylor series: a few ulp for every angle in [1e-12, pi].
#include "lie/small_angle.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

using namespace kreisel;

#if !KREISEL_QUAD

namespace {

using Wide = __float128;

/// sum_k (-1)^k (k + drop)!/k! s^k / (2 (k + drop) + shift)! times (-1)^drop: the drop-th derivative in s of
/// sum (-s)^k / (2k + shift)!, summed until it no longer changes.
Wide alternating(Wide s, int shift, int drop) {
    Wide term = 1;
    for (int i = 2; i <= 2 * drop + shift; ++i) term /= i;
    for (int i = 2; i <= drop; ++i) term *= i;
    if (drop % 2 == 1) term = -term;
    Wide sum = 0;
    for (int k = 0; k < 200; ++k) {
        const Wide next = sum + term;
        if (next == sum) break;
        sum = next;
        const int m = 2 * (k + drop) + shift;
        term *= -s * (k + 1 + drop) / (k + 1) / ((m + 1) * (m + 2));
    }
    return sum;
}

/// cotc = j(s/4) / (4 sinc(s/4)), with j(x^2) = (sin x - x cos x)/x^3 = sinc-like series: j = -2 d sinc/ds.
Wide wide_cotc(Wide s) {
    const Wide r = s / 4;
    return -2 * alternating(r, 1, 1) / (4 * alternating(r, 1, 0));
}

/// Its derivative by the quotient rule; the chain rule gives the factor 1/4.
Wide wide_cotc_ds(Wide s) {
    const Wide r = s / 4, f = alternating(r, 1, 0), f1 = alternating(r, 1, 1), f2 = alternating(r, 1, 2);
    return -(f2 * f - f1 * f1) / (8 * f * f);
}

struct Function {
    const char* name;
    std::function<double(double)> ours;
    std::function<Wide(Wide)> exact;
    double ulp;
};

}  // namespace

TEST_CASE("small-angle functions are accurate to a few ulp from 1e-12 to pi", "[lie]") {
    const Function functions[] = {
        {"sinc", sinc, [](Wide s) { return alternating(s, 1, 0); }, 2},
        {"cosc", cosc, [](Wide s) { return alternating(s, 2, 0); }, 4},
        {"sincc", sincc, [](Wide s) { return alternating(s, 3, 0); }, 4},
        {"cosc_ds", cosc_ds, [](Wide s) { return alternating(s, 2, 1); }, 4},
        {"sincc_ds", sincc_ds, [](Wide s) { return alternating(s, 3, 1); }, 8},
        {"cotc", cotc, wide_cotc, 4},
        {"cotc_ds", cotc_ds, wide_cotc_ds, 16},
    };
    for (const Function& function : functions) {
        double worst = 0, at = 0;
        for (int i = 0; i <= 20000; ++i) {
            const double t = 1e-12 * std::pow(3.141592653589793 / 1e-12, i / 20000.0), s = t * t;
            const Wide exact = function.exact(s);
            // sinc vanishes at pi: its error is taken relative to 1, its size in a rotation.
            const Wide size = std::string(function.name) == "sinc" ? Wide(1) : exact;
            const double ulps =
                std::abs(static_cast<double>((function.ours(s) - exact) / size)) / 2.220446049250313e-16;
            if (ulps > worst) worst = ulps, at = t;
        }
        INFO(function.name << ": " << worst << " ulp at t = " << at);
        CHECK(worst <= function.ulp);
    }
}

TEST_CASE("the check above rejects the textbook formulas", "[lie][control]") {
    const double t = 1e-3, s = t * t;
    const Wide exact = alternating(s, 2, 0);
    const double naive = (1 - std::cos(t)) / s;
    CHECK(std::abs(static_cast<double>((naive - exact) / exact)) > 100 * 2.220446049250313e-16);
}

#endif

TEST_CASE("Bernoulli numbers over factorials", "[lie]") {
    // B_2/2! = 1/12, B_4/4! = -1/720, B_6/6! = 1/30240, B_8/8! = -1/1209600.
    const long denominators[] = {12, 720, 30240, 1209600};
    for (std::size_t k = 0; k < 4; ++k) {
        const Real error = Real(series::bernoulli[k]) * Real(denominators[k]) - 1;
        CHECK(abs(error) <= 4 * epsilon);
    }
}
