// SPDX-License-Identifier: BSD-3-Clause
//
// What trials tell of the properties that a method declares, and of those that it does not.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/engine.hpp"
#include "records/results.hpp"

namespace kreisel {

struct Findings {
    std::vector<std::string> remarks;     ///< properties that were seen and are not declared
    std::vector<std::string> complaints;  ///< properties that are declared and were not, or could not be, seen
};

/// Of the trial certified_structure: a method has a property on a class of systems (methods/contract/claims.hpp) if
/// every cell of the class keeps it: the two-form and the reversal of steps as far as can be seen at three step sizes,
/// energy, momenta and constraints up to 1e4 units of round-off over the run. A cell is of the class free where its
/// problem is free_top, else potential where its formulation has no joints (SO3, S3, SO3-LiePoisson), else constrained.
/// A declared class of which there is no cell, autonomous counted as constrained, is a complaint too.
Findings structure_findings(const MethodDescription& method, const Results& results);

/// Of the trial certified_energy: where it declares a property that bounds the energy error, symplectic or
/// energy-preserving, the error must be kept or bounded.
Findings energy_findings(const MethodDescription& method, const Results& results);

}  // namespace kreisel
