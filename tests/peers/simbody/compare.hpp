// SPDX-License-Identifier: BSD-3-Clause
//
// Comparison with Simbody: accelerations of all bodies and the joint forces.
#pragma once

#include <vector>

#include "mechanics/formulation.hpp"
#include "tests/peers/simbody/translate.hpp"

namespace outside {

/// Largest differences over all bodies, relative to the largest value of any body or to 1 (SI units), where that is
/// larger.
struct Difference {
    Real state = 0;         ///< of the states on both sides: Simbody can represent the state
    Real acceleration = 0;  ///< x'' and omega'
    Real reaction = 0;      ///< forces and torques of the joints of the tree
};

/// Of a formulation of `model` from Simbody's version of `other`, at a state on the joints. Reactions are compared
/// where they are unique.
Difference difference(const Model& model, const std::string& formulation, const Model& other,
                      const std::vector<BodyState>& bodies);

std::vector<Acceleration> accelerations(System& system, const std::string& formulation,
                                        const std::vector<BodyState>& bodies);

}  // namespace outside
