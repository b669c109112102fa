// SPDX-License-Identifier: GPL-3.0-or-later
//
// The angular velocity of the free body from the classical solution and the Jacobi functions of [gsl], which share only
// the data with the closed form under test.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_elljac.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "problems/problem.hpp"
#include "tests/engine/free_bodies.hpp"

using namespace reference_tests;

namespace {

using Triple = std::array<double, 3>;

/// sn, cn, dn at u for the parameter m = k^2.
Triple jacobi_functions(double u, double m) {
    Triple f{};
    // The default handler would end the program instead of the test case.
    gsl_error_handler_t* const before = gsl_set_error_handler_off();
    const int status = gsl_sf_elljac_e(u, m, &f[0], &f[1], &f[2]);
    gsl_set_error_handler(before);
    REQUIRE(status == GSL_SUCCESS);
    return f;
}

/// omega(t) for moments I1 < I2 < I3 and omega(0) = (w1, 0, w3), w1, w3 > 0. With M^2 > 2 E I2
///   omega = (a cn u, b sn u, c dn u),  u = t sqrt((I3 - I2)(M^2 - 2 E I1)/(I1 I2 I3)),
///   k^2 = (I2 - I1)(2 E I3 - M^2)/((I3 - I2)(M^2 - 2 E I1));
/// otherwise the same with axes 1 and 3 exchanged. `parameter` turns k^2 into what the Jacobi functions are given.
template <class Parameter>
Triple classical_omega(Triple I, Triple w, double t, Parameter parameter) {
    const double twice_E = I[0] * w[0] * w[0] + I[2] * w[2] * w[2];
    const double M2 = I[0] * I[0] * w[0] * w[0] + I[2] * I[2] * w[2] * w[2];
    const bool about_first = M2 < twice_E * I[1];
    if (about_first) { std::swap(I[0], I[2]); }
    const double D1 = M2 - twice_E * I[0], D3 = twice_E * I[2] - M2;
    const double u = t * std::sqrt((I[2] - I[1]) * D1 / (I[0] * I[1] * I[2]));
    const double k2 = (I[1] - I[0]) * D3 / ((I[2] - I[1]) * D1);
    const auto [sn, cn, dn] = jacobi_functions(u, parameter(k2));
    Triple omega = {std::sqrt(D3 / (I[0] * (I[2] - I[0]))) * cn, std::sqrt(D3 / (I[1] * (I[2] - I[1]))) * sn,
                    std::sqrt(D1 / (I[2] * (I[2] - I[0]))) * dn};
    if (about_first) { std::swap(omega[0], omega[2]); }
    return omega;
}

/// Largest distance of the closed form's omega from the classical one over times up to 20 s.
template <class Parameter>
double largest_distance(const Triple& I, const Triple& w, Parameter parameter) {
    double largest = 0;
    for (int i = 1; i <= 40; ++i) {
        const double t = i / 2.0;
        const FreeRotation closed =
            free_rotation(to_matrix(diagonal(I[0], I[1], I[2])), Mat3::Identity(), to_vector(w), Real(t));
        const Triple other = classical_omega(I, w, t, parameter);
        for (int j = 0; j < 3; ++j) {
            const double apart = std::abs(to_double(closed.omega[j]) - other.at(static_cast<std::size_t>(j)));
            largest = std::max(largest, apart);
        }
    }
    return largest;
}

constexpr Triple moments = {1, 2, 2.5};

}  // namespace

TEST_CASE("the closed form of the free body agrees with another library's Jacobi functions") {
    const auto square = [](double k2) { return k2; };
    CHECK(largest_distance(moments, {0.3, 0, 1.2}, square) < 1e-13);  // circles about axis 3
    CHECK(largest_distance(moments, {1.2, 0, 0.2}, square) < 1e-13);  // about axis 1
}

TEST_CASE("control: the modulus in place of the parameter is seen") {
    const auto modulus = [](double k2) { return std::sqrt(k2); };
    CHECK(largest_distance(moments, {0.3, 0, 1.2}, modulus) > 1e-3);
    CHECK(largest_distance(moments, {1.2, 0, 0.2}, modulus) > 1e-3);
}
