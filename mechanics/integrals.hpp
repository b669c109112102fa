// SPDX-License-Identifier: BSD-3-Clause
//
// First integrals of a model.
#pragma once

#include <vector>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The first integrals of a model, each with the reason why it holds.
std::vector<FirstIntegral> first_integrals(const Model& model);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
