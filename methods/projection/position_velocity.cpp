// SPDX-License-Identifier: BSD-3-Clause
#include "methods/projection/gauss_newton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static constexpr ProjectedLevels both_levels{.positions = true, .velocities = true};

KREISEL_PROJECTION({.name = "position_velocity",
                    .summary = "positions first, then velocities at the new position; group updates",
                    .cites = {"eich1993"},
                    .options = least_projection_options(both_levels),
                    .positions = true,
                    .velocities = true},
                   least_projection(both_levels));

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
