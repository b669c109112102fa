// SPDX-License-Identifier: BSD-3-Clause
//
// Coordinate partitioning after each step: the independent coordinates stay as they were integrated, the dependent ones
// are solved from Phi = 0, their velocities from C v + b = 0 [wehagehaug1982]. There the accelerations of
// each stage are those at corrected states; here stages drift, as under every projection.
#include "methods/projection/dependent_coordinates.hpp"
#include "methods/projection/gauss_newton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

KREISEL_PROJECTION(
    {.name = "coordinate_partitioning",
     .summary = "dependent coordinates solved from Phi = 0 and C v + b = 0, independent ones as they are; which they "
                "are depends on the axes of space and bodies",
     .cites = {"wehagehaug1982"},
     .options = {iterations_option()},
     .positions = true,
     .velocities = true},
    [](System& system, const OptionValues& options) {
        return std::make_unique<GaussNewtonProjection>(system, ProjectedLevels{.positions = true, .velocities = true},
                                                       is_once(options), in_dependent_coordinates(system));
    });

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
