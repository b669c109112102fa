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

/// The weight b_i(theta) = sum_k coefficients_k theta^(k+1) of the slope at `offset`.
struct DenseWeight {
    std::vector<Real> coefficients;
    std::size_t offset;
};

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
    std::vector<DenseWeight> dense;  ///< without those that are zero; empty where there is no dense output
    /// The b_i(theta), in storage as long as `dense`.
    void weigh(const Real& theta, Combination& weights) const;

  private:
    void bind_dense(const Tableau& tableau, std::size_t stride);
};

/// Vectors that are combined have a length that is a multiple of this, so that no loop has a remainder.
inline constexpr std::size_t vector_chunk = 4;
inline std::size_t padded(std::size_t n) { return (n + vector_chunk - 1) / vector_chunk * vector_chunk; }

/// out = h sum_j coefficient_j slope_j over `count` terms and n entries, or that added to out.
template <std::size_t count, bool more>
inline void combine_in_one_pass(const Term* terms, const Real& h, const Real* slopes, std::size_t n, Real* out) {
    Real weights[count];
    const Real* slope[count];
    for (std::size_t j = 0; j < count; ++j) weights[j] = h * terms[j].coefficient, slope[j] = slopes + terms[j].offset;
    const std::size_t whole = n / vector_chunk * vector_chunk;  // n, in a form that tells the compiler of the multiple
    KREISEL_ELEMENTWISE
    for (std::size_t k = 0; k < whole; ++k) {
        Real sum = weights[0] * slope[0][k];
        if constexpr (more) sum = out[k] + weights[0] * slope[0][k];
        for (std::size_t j = 1; j < count; ++j) sum += weights[j] * slope[j][k];
        out[k] = sum;
    }
}

/// The same for `left` further terms, four in a pass. Not inlined: short rows end before it.
[[gnu::noinline]] inline void combine_further(const Term* term, std::size_t left, const Real& h, const Real* slopes,
                                              std::size_t n, Real* out) {
    for (; left >= 4; term += 4, left -= 4) combine_in_one_pass<4, true>(term, h, slopes, n, out);
    if (left == 3) combine_in_one_pass<3, true>(term, h, slopes, n, out);
    if (left == 2) combine_in_one_pass<2, true>(term, h, slopes, n, out);
    if (left == 1) combine_in_one_pass<1, true>(term, h, slopes, n, out);
}

/// For at least one term, out = h sum_j coefficient_j slope_j over vectors of length n, a multiple of vector_chunk, in
/// passes of up to four terms. How many a pass has changes only its cost, but for the first: two products in it may be
/// fused in either way, so it has one term or four.
[[gnu::always_inline]] inline void combine(const Combination& terms, const Real& h, const Real* slopes, std::size_t n,
                                           Real* out) {
    const std::size_t first = terms.size() >= 4 ? 4 : 1;
    if (first == 4)
        combine_in_one_pass<4, false>(terms.data(), h, slopes, n, out);
    else
        combine_in_one_pass<1, false>(terms.data(), h, slopes, n, out);
    if (terms.size() > first) combine_further(terms.data() + first, terms.size() - first, h, slopes, n, out);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
