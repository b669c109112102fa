// SPDX-License-Identifier: BSD-3-Clause
//
// Parts with one fault each, of the kinds that the suite must find.
#pragma once

#include "tests/metamorphic/models/motion.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

/// Projections stop where every row, whatever its unit, is below 1e-9.
Bench with_absolute_tolerance();
/// Torsion springs measure their angle in (-pi, pi] at every moment.
Bench with_forgetful_springs();
/// The multiplier of the row that keeps a disk on its plane has the other sign; motions are correct.
Bench with_reversed_rolling_row();
/// A spring from the origin to any body called "rod".
Bench with_uninvited_spring();
/// Steps of more than 1/128 s are split in two.
Bench with_hidden_time();

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
