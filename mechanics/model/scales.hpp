// SPDX-License-Identifier: BSD-3-Clause
//
// What tolerances, ranks and round-off are relative to: the size of a mechanism, which does not depend on its place,
// and its place, which determines the round-off of positions. Scaling lengths, masses and times by powers of two scales
// these by the same powers, exactly.
#pragma once

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// sqrt(tr J / (2 m)) (m), the root mean square distance of the mass from its centre; 0 of a point mass, and
/// of NaN data, which the solves detect.
Real radius_of_gyration(const Body& body);

/// Size of a mechanism in its initial configuration (m): twice the largest distance of a mass centre or a joint point
/// from the mean of all of them, or the largest radius of gyration if that is larger. 0 where nothing has a length:
/// point masses at one point.
Real extent(const Model& model);

/// Where a mechanism is (m): the largest distance of a mass centre or a joint point from the origin.
Real remoteness(const Model& model);

/// Length (m) of a joint's rows: the largest of its arms on moving bodies, of their radii of gyration, and of the rod
/// or the radius; if all vanish, the extent of the mechanism. The ground has no arm, since its place is arbitrary. 1 if
/// there is no length at all: every residual is then zero.
Real joint_length(const Model& model, const Joint& joint);

/// Length (m) of each body, by which torques on it compare with forces: its radius of gyration or its longest arm to a
/// joint. 0 of a point mass, on which no torque acts.
std::vector<Real> body_lengths(const Model& model);

/// The power of two next below the largest finite mass (kg). Factors with a square root, such as Cholesky's, use masses
/// in this unit, so that their bits do not depend on the user's unit of mass.
Real mass_unit(const Model& model);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
