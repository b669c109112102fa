// SPDX-License-Identifier: BSD-3-Clause
//
// The path of a mass centre in space, coloured by time, with its shadow on the floor.
#include "plots/figures/kinds/space_kind.hpp"

namespace kreisel {

namespace {

class PathFigure final : public SpaceKind {};

}  // namespace

KREISEL_FIGURE(PathFigure, {.name = "path3d",
                            .summary = "the path of a mass centre in space",
                            .draws = FigureData::samples,
                            .script = "path3d",
                            .keys = space_keys()});

}  // namespace kreisel
