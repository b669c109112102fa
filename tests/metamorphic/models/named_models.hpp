// SPDX-License-Identifier: BSD-3-Clause
//
// The models that are transformed: every registered problem with its defaults, mechanisms with every joint and force,
// and some with difficult data.
#pragma once

#include <string>
#include <vector>

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

struct NamedModel {
    std::string name;
    Model model;
    Real h;  ///< s, a power of two: a fastest motion of the model turns by 1/40 to 1/20 within it
};

const std::vector<NamedModel>& named_models();
/// Throws std::out_of_range for an unknown name.
const NamedModel& named_model(const std::string& name);

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
