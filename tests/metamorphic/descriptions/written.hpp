// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

/// A model as a user would write it: its bodies, and of joints and forces those that it has.
ParameterValues written(const Model& model);

/// The model that problem `multibody` reads from this; nothing if it refuses the data.
std::optional<Model> read_again(const Model& model);

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
