// SPDX-License-Identifier: BSD-3-Clause
#include "methods/variational/modified_moments.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Real whole_power(const Real& x, int n) {
    Real product = 1;
    for (int i = 0; i < (n < 0 ? -n : n); ++i) product *= x;
    return n < 0 ? Real(1 / product) : product;
}

/// sum_j I_j^n.
Real sum_of(const Vec3& I, int n) { return whole_power(I[0], n) + whole_power(I[1], n) + whole_power(I[2], n); }

/// sum_{i != j} I_i^a / I_j^b.
Real mixed(const Vec3& I, int a, int b) {
    Real sum = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (i != j) sum += whole_power(I[i], a) * whole_power(I[j], -b);
    return sum;
}

}  // namespace

ModifiedMoments::ModifiedMoments(const Vec3& I, int terms) : inverse_(I.cwiseInverse()), terms_(terms) {
    const Real D = I.prod(), D2 = D * D, D3 = D2 * D, D4 = D3 * D;
    const Real P1 = sum_of(I, 1), P2 = sum_of(I, 2), P3 = sum_of(I, 3), P4 = sum_of(I, 4);
    const Real N1 = sum_of(I, -1), N2 = sum_of(I, -2), N3 = sum_of(I, -3), N4 = sum_of(I, -4);
    const Real X11 = mixed(I, 1, 1), X12 = mixed(I, 1, 2), X21 = mixed(I, 2, 1);
    const Real X13 = mixed(I, 1, 3), X31 = mixed(I, 3, 1), X22 = mixed(I, 2, 2);
    s_ = {{{P1 / (6 * D), -N1 / 3},
           {(P2 / D - N1) / (30 * D), (1 - X11) / (30 * D), (3 * P1 / D + 2 * N2) / 60},
           {(4 * D + 17 * P3 - 15 * D * X11) / (2520 * D3), (9 * P1 + 10 * D * N2 - 6 * X21) / (420 * D2),
            ((6 * X12 - 100 * N1) * D + 53 * P2) / (2520 * D2), (15 - D * N3 - 2 * X11) / (630 * D)},
           {(62 * P4 - 94 * D * X21 + 66 * D2 * N2 + 81 * D * P1) / (45360 * D4),
            (-77 * X31 + 75 * D * X12 + 214 * P2 - 240 * D * N1) / (22680 * D3),
            (26 * D * X22 + 55 * P3 + 204 * D - 50 * D2 * N3 - 59 * D * X11) / (7560 * D3),
            (137 * D * N2 - D * X13 + 3 * P1 - 69 * X21) / (11340 * D2),
            (2 * D2 * N4 + 5 * D * X12 - 171 * D * N1 + 159 * P2) / (45360 * D2)}}};
    d_ = {{{-1 / (3 * D), P1 / (6 * D)},
           {-P1 / (60 * D2), N1 / (10 * D) - P2 / (60 * D2), -(9 + X11) / (60 * D)},
           {(34 * D * N1 - 19 * P2) / (2520 * D3), (P3 + 2 * D * X11 - 85 * D) / (1260 * D3),
            (47 * P1 + 13 * X21 - 38 * D * N2) / (2520 * D2), (9 * D * N1 + D * X12 - 11 * P2) / (1260 * D2)},
           {(60 * X11 * D - 61 * P3 - 247 * D) / (45360 * D4),
            (54 * D * P1 - P4 + 218 * D * X21 - 426 * D2 * N2) / (45360 * D4),
            (125 * D * N1 - 5 * X31 - 130 * P2 + 4 * D * X12) / (7560 * D3),
            (67 * P3 - 735 * D - 15 * D * X22 + 87 * D * X11 + 34 * D2 * N3) / (22680 * D3),
            (165 * P1 - D * X13 - 9 * X21 - 145 * D * N2) / (45360 * D2)}}};
}

Vec3 ModifiedMoments::inverse(const Vec3& m, const Real& h) const {
    const Real C = h * h * m.squaredNorm() / 2, H = h * h * m.dot(inverse_.cwiseProduct(m)) / 2;
    Real s = 1, d = 0;
    for (int k = 1; k <= terms_; ++k) {
        Real of_H = 1;  // H^j
        for (int j = 0; j <= k; ++j, of_H *= H) {
            const Real product = whole_power(C, k - j) * of_H;
            const auto row = static_cast<std::size_t>(k - 1), column = static_cast<std::size_t>(j);
            s += s_[row][column] * product;
            d += d_[row][column] * product;
        }
    }
    return s * inverse_ + Vec3::Constant(d);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
