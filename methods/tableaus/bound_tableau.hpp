// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lie/real.hpp"
#include "methods/tableaus/tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

Real value(const Coefficient& coefficient);

/// A linear combination of stages without its zeros. The slope of a stage lies at `offset` in the storage of all
/// slopes.
struct Term {
    Real coefficient;
    std::size_t offset;
};
using Combination = std::vector<Term>;

/// Stages up to the last one that the weights b use; an embedded pair may have more.
int stages_of_step(const Tableau& tableau);
/// Whether the last stage of a pair is taken where the step ends, so that it is the first one of the next step.
bool first_same_as_last(const Tableau& tableau);

/// A tableau as numbers, bound to slopes that lie `stride` reals apart. Throws std::invalid_argument where it is not
/// explicit, sum b or sum b_hat is not 1, or a given node is not the sum of its row.
struct BoundTableau {
    BoundTableau(const Tableau& tableau, std::size_t stride);
    std::size_t stages() const { return a.size(); }  ///< all of them
    std::size_t stages_of_step;                      ///< without those only the estimate uses
    bool first_same_as_last;
    std::vector<Combination> a;
    Combination b;
    Combination error;  ///< b - b_hat; empty where there is no b_hat
    std::vector<Real> c;
};

/// Vectors that are combined have a length that is a multiple of this, so that no loop has a remainder.
inline constexpr std::size_t vector_chunk = 4;
inline std::size_t padded(std::size_t n) { return (n + vector_chunk - 1) / vector_chunk * vector_chunk; }

/// For at least one term, out = h sum_j coefficient_j slope_j over vectors of length n, a multiple of vector_chunk; one
/// pass for up to four terms.
inline void combine(const Combination& terms, const Real& h, const Real* slopes, std::size_t n, Real* __restrict out) {
    const std::size_t whole = n / vector_chunk * vector_chunk;  // n, in a form that tells the compiler of the multiple
    const auto each = [&](auto&& entry) {
        for (std::size_t k = 0; k < whole; ++k) entry(k);
    };
    const Term* term = terms.data();
    const Term* const end = term + terms.size();
    const auto slope = [&](const Term& t) { return slopes + t.offset; };
    if (end - term >= 4) {
        const Real w0 = h * term[0].coefficient, w1 = h * term[1].coefficient;
        const Real w2 = h * term[2].coefficient, w3 = h * term[3].coefficient;
        const Real *k0 = slope(term[0]), *k1 = slope(term[1]), *k2 = slope(term[2]), *k3 = slope(term[3]);
        each([&](std::size_t k) { out[k] = w0 * k0[k] + w1 * k1[k] + w2 * k2[k] + w3 * k3[k]; });
        term += 4;
    } else {
        const Real w0 = h * term[0].coefficient;
        const Real* k0 = slope(term[0]);
        each([&](std::size_t k) { out[k] = w0 * k0[k]; });
        term += 1;
    }
    for (; term != end; ++term) {
        const Real w = h * term->coefficient;
        const Real* k0 = slope(*term);
        each([&](std::size_t k) { out[k] += w * k0[k]; });
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
