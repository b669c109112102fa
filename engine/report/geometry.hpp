// SPDX-License-Identifier: BSD-3-Clause
//
// The geometry of a model as plain data.
#pragma once

#include "engine/geometry.hpp"
#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Numbers rounded to double.
Geometry to_geometry(const Model& model);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
