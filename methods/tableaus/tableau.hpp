// SPDX-License-Identifier: BSD-3-Clause
//
// Butcher tableaus of explicit methods, as declared (methods/tableaus/bound_tableau.hpp binds them to numbers).
#pragma once

#include <string>
#include <vector>

#include "methods/tableaus/coefficient.hpp"

namespace kreisel {

/// Explicit tableau: row i of `a` holds a_i1 ... a_i,i-1 (the first is empty); c_i = sum_j a_ij is derived. `b`
/// advances the solution. Of an embedded pair, `b_hat` are the weights of the solution it is compared with. Nodes given
/// in `c` must be the sums of the rows, which finds the misprinted one. Row i of `dense` holds the coefficients of
/// theta, theta^2, ... in b_i(theta), the weights of a solution at t + theta h; no rows: the method has none.
struct Tableau {
    std::vector<std::vector<Coefficient>> a;
    std::vector<Coefficient> b;
    std::vector<Coefficient> b_hat = {};
    std::vector<Coefficient> c = {};
    std::vector<std::vector<Coefficient>> dense = {};
};

}  // namespace kreisel
