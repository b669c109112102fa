// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
    int stages() const { return static_cast<int>(a.size()); }
    std::vector<Combination> a;
    Combination b;
    std::vector<Real> c;
};

/// out = h sum_j coefficient_j slope_j over vectors of length n that lie one after another in `slopes`, in one pass.
void combine(const Combination& terms, const Real& h, const Real* slopes, int n, Real* out);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
