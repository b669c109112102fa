// SPDX-License-Identifier: BSD-3-Clause
//
// Every stored series coefficient against exact rational arithmetic, one by one: function values would hide an error in
// a high coefficient.
#include <catch2/catch.hpp>

#include "lie/chart.hpp"
#include "lie/small_angle.hpp"
#include "tests/lie/exact.hpp"

using namespace kreisel;
using exact::Decimal;
using exact::Rational;

namespace {

/// Coefficient k of a series in s.
using Definition = Rational (*)(int k, const std::vector<Rational>& B);

Rational signed_factorial(int k, int n) { return (k % 2 == 0 ? 1 : -1) / exact::factorial(n); }
Rational sinc_of(int k, const std::vector<Rational>&) { return signed_factorial(k, 2 * k + 1); }
Rational cosc_of(int k, const std::vector<Rational>&) { return signed_factorial(k, 2 * k + 2); }
Rational sincc_of(int k, const std::vector<Rational>&) { return signed_factorial(k, 2 * k + 3); }
Rational cotc_of(int k, const std::vector<Rational>& B) {
    const auto p = static_cast<std::size_t>(2 * k + 2);
    return abs(B[p]) / exact::factorial(2 * k + 2);
}
template <Definition f>
Rational derivative_of(int k, const std::vector<Rational>& B) {
    return (k + 1) * f(k + 1, B);
}

struct Worst {
    double ulps = 0;
    int index = -1;
};

/// Largest relative error in units of `unit`, the spacing at 1: at least the error in ulps.
template <class Array>
Worst worst_error(const Array& stored, Definition definition, const Decimal& unit, const Decimal& factor = 1) {
    static const auto B = exact::bernoulli_numbers(2 * 64);
    Worst worst;
    for (std::size_t k = 0; k < stored.size(); ++k) {
        const Decimal value = exact::decimal(definition(static_cast<int>(k), B));
        const Decimal error = abs((exact::decimal_of(stored[k]) * factor - value) / value) / unit;
        if (worst.index < 0 || error > worst.ulps) worst = {error.convert_to<double>(), static_cast<int>(k)};
    }
    return worst;
}

const Decimal ulp = exact::decimal_of(epsilon);
const Decimal wide_ulp = ldexp(Decimal(1), -112);

/// The recursions run in 113 bits and lose a few ulp of these: 1.8 in the factorials, a quarter per coefficient in the
/// Bernoulli numbers. Double is rounded once, at their end.
const double recursion = 16, bernoulli_limit = KREISEL_QUAD ? recursion : 1, factorial_limit = KREISEL_QUAD ? 2 : 1;

template <class Array>
void check(const char* name, const Array& stored, Definition definition, double limit, const Decimal& unit = ulp) {
    const Worst worst = worst_error(stored, definition, unit);
    INFO(name << ", coefficient " << worst.index << ": " << worst.ulps << " ulp");
    CHECK(worst.ulps <= limit);
    // A relative error of 1e-6 in any of them must not pass.
    for (const int sign : {-1, 1})
        CHECK(worst_error(stored, definition, unit, 1 + sign * Decimal(1) / 1000000).ulps > 1000);
}

/// The algebra R^n with a bracket that moves every entry on by one, whatever u is: dexpinv applied to the first unit
/// vector lists its own coefficients.
class Shift final : public Group {
  public:
    explicit Shift(int n) : Group(n, n) {}
    void bracket(const Real*, const Real* v, Real* out) const override {
        for (int i = dim() - 1; i > 0; --i) out[i] = v[i - 1];
        out[0] = 0;
    }
    bool in_exp_chart(const Real*) const override { return true; }
    void identity(Real*) const override {}
    void multiply(const Real*, const Real*, Real*) const override {}
    void inverse(const Real*, Real*) const override {}
    void log(const Real*, Real*) const override {}
    void Ad(const Real*, const Real*, Real*) const override {}
    void coAd(const Real*, const Real*, Real*) const override {}
    void dexp(const Real*, const Real*, Real*) const override {}
    void append_exp(const Real*, const Real*, Real*) const override {}
    void append_cay(const Real*, const Real*, Real*) const override {}
    bool dexpinv_left(const Real*, const Real*, Real*) const override { return true; }
    void dcayinv_left(const Real*, const Real*, Real*) const override {}
    bool dexpinv_left_transpose(const Real*, const Real*, Real*) const override { return true; }
    void dcayinv_left_transpose(const Real*, const Real*, Real*) const override {}
    Real orthogonality_defect(const Real*) const override { return 0; }
};

}  // namespace

TEST_CASE("every stored series coefficient is its factorial or Bernoulli number, to one ulp in double", "[lie]") {
    check("sinc", series::sinc, sinc_of, factorial_limit);
    check("cosc", series::cosc, cosc_of, factorial_limit);
    check("sincc", series::sincc, sincc_of, factorial_limit);
    check("cosc_ds", series::cosc_ds, derivative_of<cosc_of>, factorial_limit);
    check("sincc_ds", series::sincc_ds, derivative_of<sincc_of>, factorial_limit);
    check("cotc", series::cotc, cotc_of, bernoulli_limit);
    check("cotc_ds", series::cotc_ds, derivative_of<cotc_of>, bernoulli_limit);
    check("bernoulli", series::bernoulli, cotc_of, recursion, wide_ulp);
}

TEST_CASE("the truncated dexpinv has the coefficients (-1)^p B_p / p!, up to its number of brackets", "[lie]") {
    const auto expected = exact::left_coefficients(max_brackets);
    const Shift group(max_brackets + 2);
    const auto n = static_cast<std::size_t>(group.dim());
    for (int brackets = 0; brackets <= max_brackets; ++brackets) {
        std::vector<Real> u(n, Real(0)), v(n, Real(0)), out(n);
        v[0] = 1;
        TruncatedExpChart(group, brackets).pull_back(u.data(), v.data(), out.data());
        for (std::size_t p = 0; p < n; ++p) {
            INFO("q = " << brackets << ", p = " << p);
            const Decimal value = p <= static_cast<std::size_t>(brackets) ? expected[p] : Decimal(0);
            CHECK(abs(exact::decimal_of(out[p]) - value) <= bernoulli_limit * ulp * abs(value));
        }
    }
}
