// SPDX-License-Identifier: BSD-3-Clause
//
// Stability on the test rotation against what is known of the imaginary axis [hairer1996, Sec. IV.2, V.1].
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

#include "engine/stability/test_rotation.hpp"

namespace stability_tests {

using namespace kreisel;

namespace {

RotationStability stability(const Method& entry) {
    return rotation_stability(entry, with_defaults({}, entry.description.options));
}
double limit_of(const char* name) {
    const RotationStability found = stability(method(name));
    INFO(name << ": " << found.refusal);
    CHECK(found.refusal == "");
    CHECK(found.bounded);
    return found.limit;
}

/// The largest |w| of the characteristic polynomial of an Adams-Bashforth method at z = i y, by power iteration of its
/// recurrence w_{n+1} = w_n + z sum_j beta_j w_{n-j}: an evaluation that shares nothing with the method.
double adams_bashforth_growth(const std::vector<double>& beta, double y) {
    std::vector<std::complex<double>> w(beta.size(), 1.0);
    w.back() = {0.3, 0.2};
    const int steps = 20000;
    double grown = 0;
    for (int n = 0; n < 2 * steps; ++n) {
        std::complex<double> next = w[0];
        for (std::size_t j = 0; j < beta.size(); ++j) next += std::complex<double>(0, y * beta[j]) * w[j];
        std::rotate(w.rbegin(), w.rbegin() + 1, w.rend());
        w[0] = next;
        const double size = std::abs(next);
        if (n >= steps) grown += std::log(size);
        for (auto& one : w) one /= size;
    }
    return std::exp(grown / steps) - 1;
}

}  // namespace

TEST_CASE("limits on the test rotation are those of the imaginary axis", "[stability]") {
    CHECK(limit_of("rkmk/rk4") == Approx(2 * std::sqrt(2.0)).epsilon(1e-6));
    CHECK(limit_of("rkmk/kutta3") == Approx(std::sqrt(3.0)).epsilon(1e-6));
    CHECK(limit_of("crouch_grossman/cg3a") == Approx(std::sqrt(3.0)).epsilon(1e-6));
    CHECK(limit_of("commutator_free/cf4") == Approx(2 * std::sqrt(2.0)).epsilon(1e-6));
    CHECK(limit_of("variational/lie_verlet") == Approx(2).epsilon(1e-6));
    CHECK(limit_of("splitting/strang") == Approx(2).epsilon(1e-6));
    for (const char* name :
         {"rkmk/euler", "rkmk/midpoint", "rkmk/heun", "crouch_grossman/cg2", "extrapolation/gragg10"})
        CHECK(limit_of(name) == 0);
}

TEST_CASE("limits of methods with memory", "[stability]") {
    CHECK(limit_of("multistep/adams_bashforth2") == 0);
    CHECK(limit_of("multistep/adams_bashforth3") == Approx(0.7236).margin(1e-4));
    CHECK(limit_of("multistep/adams_bashforth4") == Approx(0.4300).margin(1e-4));
    const std::vector<double> third = {23 / 12.0, -16 / 12.0, 5 / 12.0};
    CHECK(stability(method("multistep/adams_bashforth3")).growth ==
          Approx(adams_bashforth_growth(third, 0.5)).margin(1e-6));
    const std::vector<double> fourth = {55 / 24.0, -59 / 24.0, 37 / 24.0, -9 / 24.0};
    CHECK(stability(method("multistep/adams_bashforth4")).growth ==
          Approx(adams_bashforth_growth(fourth, 0.5)).epsilon(1e-3));
}

TEST_CASE("A-stable methods have no limit", "[stability]") {
    for (const char* name : {"rkmk/implicit_midpoint", "rkmk/gauss2", "rkmk/radau2a2", "generalized_alpha/index2"}) {
        const RotationStability found = stability(method(name));
        INFO(name << ": " << found.limit << " " << found.refusal);
        CHECK_FALSE(found.bounded);
        CHECK(found.limit > 80);
    }
    CHECK(stability(method("rkmk/gauss2")).growth == Approx(0).margin(1e-20));
}

TEST_CASE("growth at half a radian a step is that of the stability function", "[stability]") {
    const auto growth = [](const std::vector<double>& coefficients) {
        std::complex<double> sum = 0, power = 1;
        for (const double c : coefficients) sum += c * power, power *= std::complex<double>(0, 0.5);
        return std::abs(sum) - 1;
    };
    CHECK(stability(method("rkmk/euler")).growth == Approx(growth({1, 1})).epsilon(1e-10));
    CHECK(stability(method("rkmk/heun")).growth == Approx(growth({1, 1, 1 / 2.0})).epsilon(1e-10));
    CHECK(stability(method("rkmk/rk4")).growth == Approx(growth({1, 1, 1 / 2.0, 1 / 6.0, 1 / 24.0})).epsilon(1e-10));
}

TEST_CASE("what takes no steps of a size, or no forces, has no limit", "[stability]") {
    CHECK(stability(method("variational/dmv")).refusal == "it does not treat forces");
    for (const Method& entry : methods())
        if (entry.description.own_control) CHECK(stability(entry).refusal == "it chooses its steps itself");
}

TEST_CASE("every method has a limit or a reason", "[stability]") {
    for (const Method& entry : methods()) {
        const RotationStability found = stability(entry);
        INFO(entry.description.name << ": " << found.limit << ", " << found.growth << " " << found.refusal);
        CHECK((!found.refusal.empty() || std::isfinite(found.growth)));
    }
}

}  // namespace stability_tests
