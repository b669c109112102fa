// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lie/real.hpp"
#include "methods/tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

Real value(const Coefficient& coefficient);

/// A linear combination of stages without its zeros.
struct Term {
    Real coefficient;
    int stage;
};
using Combination = std::vector<Term>;

/// A tableau as numbers. Throws std::invalid_argument where it is not explicit or sum b is not 1.
struct BoundTableau {
    explicit BoundTableau(const Tableau& tableau);
    std::size_t stages() const { return a.size(); }
    std::vector<Combination> a;
    Combination b;
    std::vector<Real> c;
};

/// For at least one term, out = h sum_j coefficient_j slope_j over vectors of length n that lie one after another in `slopes`, in one pass for
/// up to four terms.
inline void combine(const Combination& terms, const Real& h, const Real* slopes, std::size_t n, Real* __restrict out) {
    const Term* term = terms.data();
    const Term* const end = term + terms.size();
    const auto slope = [&](int j) { return slopes + static_cast<std::size_t>(term[j].stage) * n; };
    if (end - term >= 4) {
        const Real w0 = h * term[0].coefficient, w1 = h * term[1].coefficient;
        const Real w2 = h * term[2].coefficient, w3 = h * term[3].coefficient;
        const Real *k0 = slope(0), *k1 = slope(1), *k2 = slope(2), *k3 = slope(3);
        for (std::size_t i = 0; i < n; ++i) out[i] = w0 * k0[i] + w1 * k1[i] + w2 * k2[i] + w3 * k3[i];
        term += 4;
    } else if (end - term >= 2) {
        const Real w0 = h * term[0].coefficient, w1 = h * term[1].coefficient;
        const Real *k0 = slope(0), *k1 = slope(1);
        for (std::size_t i = 0; i < n; ++i) out[i] = w0 * k0[i] + w1 * k1[i];
        term += 2;
    } else {
        const Real w0 = h * term[0].coefficient;
        const Real* k0 = slope(0);
        for (std::size_t i = 0; i < n; ++i) out[i] = w0 * k0[i];
        term += 1;
    }
    for (; term != end; ++term) {
        const Real w = h * term->coefficient;
        const Real* k = slope(0);
        for (std::size_t i = 0; i < n; ++i) out[i] += w * k[i];
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
