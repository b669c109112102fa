// SPDX-License-Identifier: BSD-3-Clause
//
// Springs and loads as a user writes them down, checked and added to a model. Errors are ParameterErrors at JSON
// pointers below the parameters ("/forces/0/between/1").
#pragma once

#include <vector>

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Adds springs and loads on bodies of the model; a free length that is not given is that of the configuration.
void read_forces(Model& model, const std::vector<ForceData>& forces);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
