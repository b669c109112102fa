// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver/config/reading/printed.hpp"

#include <fmt/format.h>
#include <gsl/gsl_eigen.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "records/json/model_keys.hpp"

namespace kreisel {

namespace {

using Numbers = std::span<const double>;

constexpr double accepted = 1e-9;  // what the engine takes for orthogonal, or for a norm of 1
constexpr double largest_relative_change = 1e-5;
constexpr double least_size = 1e-100;  // below it, and above its inverse, products leave the range of doubles

// Decimals of the shortest text of a number: 7 of 0.7071068, 9 of 1.25e-07.
int decimals(double number) {
    const std::string text = fmt::format("{}", number);
    const std::size_t exponent = text.find('e'), mantissa = std::min(exponent, text.size()), point = text.find('.');
    const int after = point < mantissa ? static_cast<int>(mantissa - point - 1) : 0;
    return after - (exponent < text.size() ? std::stoi(text.substr(exponent + 1)) : 0);
}

double largest(Numbers numbers) {
    double size = 0;
    for (const double number : numbers) { size = std::max(size, std::abs(number)); }
    return size;
}

// Of the text, or of the arithmetic that computed what all digits are printed of.
double largest_change_of_round_off(Numbers numbers) {
    int most = 0;
    for (const double number : numbers) { most = std::max(most, decimals(number)); }
    const double size = largest(numbers), of_arithmetic = 16 * std::numeric_limits<double>::epsilon() * size;
    return std::min(std::max(2 * std::pow(10.0, -most), of_arithmetic), largest_relative_change * size);
}

double difference(Numbers a, Numbers b) {
    double size = 0;
    for (std::size_t i = 0; i < a.size(); ++i) { size = std::max(size, std::abs(a[i] - b[i])); }
    return size;
}

void warn(const Node& node, const std::string& what, const std::string& taken, double change) {
    node.warn(fmt::format("{} as printed: {} is taken, which changes entries by up to {:.2g}", what, taken, change));
}

double entry(const Matrix3& A, std::size_t i, std::size_t j) { return A[3 * i + j]; }

// R^T R - I.
Matrix3 orthogonality_defect(const Matrix3& R) {
    Matrix3 defect{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            double sum = i == j ? -1 : 0;
            for (std::size_t k = 0; k < 3; ++k) { sum += entry(R, k, i) * entry(R, k, j); }
            defect[3 * i + j] = sum;
        }
    }
    return defect;
}

// Newton's iteration R <- R (3 - R^T R)/2 = R - R (R^T R - I)/2 for the polar factor of a matrix that is nearly one.
Matrix3 polar_factor(Matrix3 R) {
    for (int step = 0; step < 4; ++step) {
        const Matrix3 old = R, defect = orthogonality_defect(R);
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
                for (std::size_t k = 0; k < 3; ++k) { R[3 * i + j] -= entry(old, i, k) * entry(defect, k, j) / 2; }
            }
        }
    }
    return R;
}

Matrix3 symmetric_part(const Matrix3& J) {
    Matrix3 symmetric{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) { symmetric[3 * i + j] = (entry(J, i, j) + entry(J, j, i)) / 2; }
    }
    return symmetric;
}

// The least eigenvalue of P = tr(J)/2 - J, and tr(P+) - P+.
struct Triangle {
    double least = 0;
    Matrix3 nearest{};
};

Triangle triangle(const Matrix3& J) {
    const double half_trace = (J[0] + J[4] + J[8]) / 2;
    std::array<double, 9> P{}, vectors{};
    for (std::size_t i = 0; i < 9; ++i) { P[i] = (i % 4 == 0 ? half_trace : 0) - J[i]; }
    std::array<double, 3> values{};
    const auto matrix = [](std::array<double, 9>& data) { return gsl_matrix_view_array(data.data(), 3, 3); };
    auto P_view = matrix(P), vectors_view = matrix(vectors);
    auto values_view = gsl_vector_view_array(values.data(), 3);
    gsl_eigen_symmv_workspace* workspace = gsl_eigen_symmv_alloc(3);
    gsl_eigen_symmv(&P_view.matrix, &values_view.vector, &vectors_view.matrix, workspace);
    gsl_eigen_symmv_free(workspace);
    Triangle result{*std::min_element(values.begin(), values.end()), {}};
    double trace = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double positive = std::max(values[k], 0.0);
        trace += positive;
        for (std::size_t i = 0; i < 9; ++i) {
            result.nearest[i] -= positive * entry(vectors, i / 3, k) * entry(vectors, i % 3, k);
        }
    }
    for (const std::size_t i : {0U, 4U, 8U}) { result.nearest[i] += trace; }
    result.nearest = symmetric_part(result.nearest);
    return result;
}

}  // namespace

Matrix3 PrintedNumbers::rotation(const Node& node, const Matrix3& R) const {
    const double defect = largest(orthogonality_defect(R));
    if (exact_ || defect < accepted / 10 || !(defect < 0.01)) { return R; }
    const Matrix3 nearest = polar_factor(R);
    const double change = difference(R, nearest);
    if (!(change <= largest_change_of_round_off(R))) { return R; }
    warn(node, "not orthogonal", "the nearest rotation", change);
    return nearest;
}

std::optional<std::array<double, 4>> PrintedNumbers::quaternion(const Node& node,
                                                                const std::array<double, 4>& q) const {
    const double norm = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
    const std::array<double, 4> unit = {q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm};
    if (std::abs(norm - 1) <= accepted) { return unit; }
    const double change = difference(q, unit), most = largest_change_of_round_off(q);
    if (exact_ || !(norm > 0) || !(change <= most)) {
        node.violates(Rule::unit_norm, "a unit quaternion (norm 1 within 1e-9, or as its decimals allow)",
                      fmt::format("norm {}", norm));
        return std::nullopt;
    }
    warn(node, fmt::format("of norm {}", norm), "the unit quaternion of its direction", change);
    return unit;
}

std::optional<Matrix3> PrintedNumbers::inertia(const Node& node, const Matrix3& J) const {
    const Matrix3 symmetric = symmetric_part(J);
    const double asymmetry = difference(J, symmetric), most = largest_change_of_round_off(J);
    if (asymmetry > 0 && (exact_ || !(asymmetry <= most))) {
        node.violates(Rule::symmetry, expectation(ValueKind::inertia),
                      fmt::format("a matrix that is not symmetric: an entry is {:.2g} off its symmetric part, {:.2g} "
                                  "are round-off of the decimals",
                                  asymmetry, exact_ ? 0 : most));
        return std::nullopt;
    }
    if (asymmetry > 0) { warn(node, "not symmetric", "the symmetric part", asymmetry); }
    if (exact_ || !(largest(J) > least_size && largest(J) < 1 / least_size)) { return symmetric; }
    const Triangle moments = triangle(symmetric);
    const double change = difference(symmetric, moments.nearest);
    const bool holds = moments.least >= -1e-13 * largest(J);  // within what the engine takes for equality
    if (holds || !(change <= most)) { return symmetric; }
    warn(node, "an inertia that no body has", "the nearest that one has", change);
    return moments.nearest;
}

}  // namespace kreisel
