// SPDX-License-Identifier: BSD-3-Clause
//
// What a refinement tells of a property of single steps, structure.*.
#pragma once

#include <optional>
#include <string>

#include "plots/tables/names.hpp"

namespace kreisel {

/// value = coefficient h^order, or zero as far as can be seen.
struct StructureLaw {
    int steps = 0;                ///< step sizes at which it was measured
    bool kept = false;            ///< at three step sizes at least, and nowhere above ten times the uncertainty
    std::optional<double> order;  ///< least-squares slope of log value against log h
    double spread = 0;            ///< largest distance of a local slope from it
    double largest = 0;           ///< value at the largest step that has one
    double uncertainty = 0;       ///< the largest
    std::string why_not;          ///< where nothing was measured
};

/// The order is that of the three finest cells with a value, where their slopes differ by less than 1/2.
StructureLaw structure_of(const CellGroup& group, const std::string& metric);

/// "kept", "h^3.00", or why neither: "-" where nothing was measured.
std::string structure_text(const StructureLaw& law);

}  // namespace kreisel
