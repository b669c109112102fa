// SPDX-License-Identifier: BSD-3-Clause
//
// Which comparisons are made: all, or few that still cover all pairs of choices.
#pragma once

#include "tests/metamorphic/descriptions/transformation.hpp"
#include "tests/metamorphic/models/named_models.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

struct Case {
    const NamedModel* model;
    const Transformation* transformation;
    Combination combination;
};
/// "heavy_top, lengths times 2^3, rkmk/rk4, SE3, none".
std::string to_text(const Case& entry);

enum class Extent {
    sparse,    ///< every two of model, transformation, method, projection, formulation meet somewhere
    pairwise,  ///< on each model: one method of each family; pairs of transformation, method, projection, formulation
    full       ///< on each model: every combination of all methods and their options
};

/// Combinations of methods, formulations and projections that run on a model.
std::vector<Combination> combinations(const Model& model, bool all_methods);

std::vector<Case> select(Extent extent);

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
