// SPDX-License-Identifier: BSD-3-Clause
//
// With h = H/n, z_0 = 0, z_1 = h k_1, z_{i+1} = z_{i-1} + 2 h f(z_i), an even z sums the slopes at odd ones before it
// with weight 2/n, an odd z those at even ones, where k_1, common to all rows of substeps, counts half. And
//   T_kk = sum_j w_j T_{j,1},   w_j = prod_{i != j} n_j^2 / (n_j^2 - n_i^2),
// the polynomial in h^2 through all rows at h = 0 in Lagrange's form; T_{k,k-1} is the same without the first row.
#include "methods/extrapolation/gragg_tableau.hpp"

#include <numeric>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

struct Fraction {
    long p = 1, q = 1;
    void multiply(long numerator, long denominator) {
        const long sign = denominator < 0 ? -1 : 1;
        const long a = std::gcd(numerator, denominator) * sign;
        numerator /= a, denominator /= a;
        const long b = std::gcd(p, denominator), c = std::gcd(numerator, q);
        p = p / b * (numerator / c), q = q / c * (denominator / b);
    }
};

/// w_j of the rows from `first` to k, times 2/n_j: what a slope at an odd z of row j counts.
Coefficient weight(int j, int first, int columns) {
    Fraction w;
    if (j < first) return 0;
    for (long i = first; i <= columns; ++i)
        if (i != j) w.multiply(static_cast<long>(j) * j, static_cast<long>(j) * j - i * i);
    w.multiply(1, j);
    return {w.p, w.q};
}

}  // namespace

Tableau gragg_tableau(int columns) {
    Tableau tableau{.a = {{}}, .b = {0}, .b_hat = {0}};
    for (int j = 1; j <= columns; ++j) {
        const int n = 2 * j;
        const std::size_t before = tableau.a.size() - 1;  // z_i has the stage before + i
        for (int i = 1; i < n; ++i) {
            std::vector<Coefficient> row(before + static_cast<std::size_t>(i), 0);
            if (i % 2 == 1) row[0] = {1, n};
            for (int m = i - 1; m > 0; m -= 2) row[before + static_cast<std::size_t>(m)] = {1, j};
            tableau.a.push_back(row);
            tableau.b.push_back(i % 2 == 1 ? weight(j, 1, columns) : 0);
            tableau.b_hat.push_back(i % 2 == 1 ? weight(j, 2, columns) : 0);
        }
    }
    return tableau;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
