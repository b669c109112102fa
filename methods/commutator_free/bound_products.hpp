// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "methods/contract/scheme.hpp"
#include "methods/tableaus/bound_tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A product of exponentials as numbers: y_from exp(...) exp(...) ...
struct BoundProduct {
    std::size_t from;  ///< of the stages, from 0
    std::vector<Combination> factors;
};

/// Stages up to the last one that the result uses.
int stages_of_step(const CommutatorFreeScheme& scheme);

/// A commutator-free scheme as numbers, bound to slopes that lie `stride` reals apart. Throws std::invalid_argument
/// where a product uses a stage that is not before it, or the coefficients of a solution do not sum to 1.
struct BoundProducts {
    BoundProducts(const CommutatorFreeScheme& scheme, std::size_t stride);
    std::vector<BoundProduct> stages;
    BoundProduct result, embedded;
    std::vector<Real> c;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
