// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/metamorphic/models/motion.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

/// The largest change of the accelerations at the start, relative to these (or those without joints), if one joint
/// after the other is replaced by a load given by its multipliers as in NOTATION.md.
Real freed_difference(const Model& model, const Bench& bench = {});

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
