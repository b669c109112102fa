// SPDX-License-Identifier: BSD-3-Clause
#include "methods/projection/gauss_newton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

static constexpr ProjectedLevels velocities_only{.velocities = true};

KREISEL_PROJECTION({.name = "velocity",
                    .summary = "velocities onto C v + b = 0, the nearest ones; positions as they are",
                    .cites = {"eich1993"},
                    .options = least_projection_options(velocities_only),
                    .velocities = true},
                   least_projection(velocities_only));

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
