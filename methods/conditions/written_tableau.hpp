// SPDX-License-Identifier: BSD-3-Clause
//
// A tableau as the options of a method write it (methods/conditions/tableau_options.hpp): "1/2; 0 1/2; 0 0 1" are rows
// from the second, the first is empty, and "1/6 1/3 1/3 1/6" weights.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "methods/conditions/numeric_tableau.hpp"
#include "methods/contract/description.hpp"

namespace kreisel::orders {

/// A tableau as methods take it, and the numbers that it writes. Where moved, its coefficients stay valid; copies would
/// point to the digits of the original.
struct WrittenTableau {
    Tableau tableau;
    NumericTableau<Rational> exact;
    std::vector<Rational> nodes;  ///< empty where none are given
    bool rounded = false;         ///< holds decimals so long that they may be
    std::deque<std::string> digits;

    WrittenTableau() = default;
    WrittenTableau(WrittenTableau&&) = default;
};

/// Throws OptionError where it has not the shape of an explicit tableau, row i of i - 1 entries, or something is not a
/// number.
WrittenTableau read_tableau(const OptionValues& options);

}  // namespace kreisel::orders
