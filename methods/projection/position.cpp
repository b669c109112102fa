// SPDX-License-Identifier: BSD-3-Clause
#include "methods/projection/gauss_newton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static constexpr ProjectedLevels positions_only{.positions = true};

KREISEL_PROJECTION({.name = "position",
                    .summary = "positions onto Phi = 0, Gauss-Newton with group updates; velocities as they are",
                    .cites = {"eich1993"},
                    .options = least_projection_options(positions_only),
                    .positions = true},
                   least_projection(positions_only));

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
