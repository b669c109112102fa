// SPDX-License-Identifier: BSD-3-Clause
//
// Comparisons that may fail, and why. An entry that no comparison needs is an error.
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

/// Exceptions inherent in a method, a projection or a description.
const std::vector<Exception>& exceptions();

/// The first entry that covers a case, or null.
const Exception* exception_for(const Case& entry);

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
