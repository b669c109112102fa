// SPDX-License-Identifier: BSD-3-Clause
//
// What tolerances, ranks and round-off are relative to. A mechanism has a size, which its place does not change, and a place,
// from which the round-off of positions follows: the two are kept apart. Lengths, masses and times multiplied by powers of two
// multiply these by the same powers, to the last bit.
#pragma once

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// sqrt(tr J / (2 m)) (m), the root mean square distance of the mass from its centre; 0 of a point mass, and
/// of data that are no numbers, which the solves find.
Real radius_of_gyration(const Body& body);

/// Size of a mechanism in its initial configuration (m): twice the largest distance of a mass centre or a joint point from
/// the mean of all of them, or the largest radius of gyration where that is more. 0 where nothing has a length: point
/// masses in one place.
Real extent(const Model& model);

/// Where a mechanism is (m): the largest distance of a mass centre or a joint point from the origin.
Real remoteness(const Model& model);

/// Length (m) of a joint's rows: the largest of its arms on moving bodies, of the radii of gyration of these, and of the
/// rod or the radius; where all vanish the extent of the mechanism. The ground has no arm: a place is no size. Where no
/// length exists at all, 1: every residual is zero there.
Real joint_length(const Model& model, const Joint& joint);

/// Length (m) of each body, by which torques on it compare with forces: its radius of gyration or its longest arm to a joint.
/// 0 of a point mass, on which no torque acts.
std::vector<Real> body_lengths(const Model& model);

/// The power of two next below the largest finite mass (kg). Factors with a square root, such as Cholesky's, are taken of
/// masses in this unit, which makes them the same bits whatever unit a user has chosen.
Real mass_unit(const Model& model);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
