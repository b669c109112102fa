// SPDX-License-Identifier: BSD-3-Clause
//
// Derivatives along a line, to nearly the accuracy of the arithmetic.
#pragma once

#include <array>

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// f'(0) of an analytic f: Real -> VecX by central differences with the steps h 2^{-k}, k = 0, ..., 8, extrapolated to
/// step zero [hairer1993, Sec. II.9]. The result is the entry of the table's diagonal that changed least,
/// since round-off grows as steps shrink. f is analytic in a disk of a few h.
template <class F>
VecX derivative_at_zero(F f, Real h) {
    constexpr std::size_t levels = 9;
    std::array<VecX, levels> row;  // T_{k,0}, T_{k,1}, ...; overwritten from the last row
    VecX best;
    Real least = 0;
    for (std::size_t k = 0; k < levels; ++k, h /= 2) {
        VecX above = (f(h) - f(-h)) / (2 * h);
        const VecX previous = k > 0 ? row[k - 1] : above;
        Real power = 1;
        for (std::size_t j = 0; j < k; ++j) {
            power *= 4;
            const VecX next = above + (above - row[j]) / (power - 1);
            row[j] = above;
            above = next;
        }
        row[k] = above;
        const Real change = (above - previous).norm();
        if (k == 1 || (k > 1 && change < least)) least = change, best = above;
    }
    return best;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
