// SPDX-License-Identifier: BSD-3-Clause
//
// Bodies, joints and forces as a user writes them down, checked and added to a model. Errors are ParameterErrors at JSON
// pointers below the parameters ("/joints/2/between/1"), the lists being the parameters "bodies", "joints" and "forces".
#pragma once

#include <string>
#include <vector>

#include "mechanics/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Adds bodies with different names: masses, inertias that a body can have, rotations. A body without v starts with v = 0.
void read_bodies(Model& model, const std::vector<BodyData>& bodies);
/// Whether each body has its own v; the argument of complete_velocities.
std::vector<bool> given_velocities(const std::vector<BodyData>& bodies);

/// Adds joints between bodies of the model, in the configuration the bodies have. Points and axes of the two bodies
/// need not meet: that is left to check_start and project_start. Axes of a universal joint must be perpendicular to 1e-9,
/// or to 30 degrees where the start is going to be projected.
void read_joints(Model& model, const std::vector<JointData>& joints, bool projected);

/// Adds springs and loads on bodies of the model; a free length that is not given is that of the configuration.
void read_forces(Model& model, const std::vector<ForceData>& forces);

/// What joints and forces share.
namespace reading {

std::string text(const Real& x);  ///< ten digits, for messages
std::string place(const char* list, std::size_t entry);

/// Index of a body, or `ground`. Throws with all names that exist.
int body_named(const Model& model, const std::string& name, const std::string& path);
/// The two of them, not the same.
std::array<int, 2> bodies_between(const Model& model, const std::array<std::string, 2>& names, const std::string& path,
                                  const std::string& who);
/// A point in the axes of a body; of a point mass it must be the mass centre, to 1e-9 of its coordinates.
Vec3 point_on(const Model& model, int body, const Vector3& point, const std::string& path, const std::string& who);
/// An axis that is not zero.
Vec3 axis(const Vector3& value, const std::string& path, const std::string& who);
/// A number at least 0.
Real not_negative(double value, const std::string& path, const std::string& what);

}  // namespace reading

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
