// SPDX-License-Identifier: BSD-3-Clause
//
// The digits of a pair that its source does not print: the order conditions solved for them.
#pragma once

#include "tests/judges/conditions/published_pairs.hpp"

namespace kreisel::orders {

struct PairSolution {
    NumericTableau<Float100> tableau;  ///< with b^
    std::vector<Entry> held;           ///< at the exact value, or where there is none, at the printed one
    Float100 moved;                    ///< the largest change of a coefficient, nodes included
    Float100 residual;
};

/// Unknown are the nodes and all coefficients that are not zero, but for the first of each row, which the node
/// determines (and the last row where it is b). A maximal set of them is held such that the conditions of the orders of
/// both solutions still determine the rest: what is known exactly first, in its order, then the earlier rows. The rest
/// follows by Newton's method. Throws std::runtime_error if that does not get below 1e-80.
PairSolution solve(const PublishedPair& pair);

}  // namespace kreisel::orders
