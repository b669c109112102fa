// SPDX-License-Identifier: BSD-3-Clause
//
// Comparisons that may fail, and why. An entry that no comparison needs any more is an error.
#pragma once

#include <string>
#include <vector>

#include "tests/metamorphic/selection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

/// Patterns, `*` standing for any text.
struct Exception {
    std::string model, transformation, method, formulation, projection, reason;
};

/// What lies in the nature of a method, a projection or a description.
const std::vector<Exception>& exceptions();

/// The first entry that a case falls under, or null.
const Exception* exception_for(const Case& entry);

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
