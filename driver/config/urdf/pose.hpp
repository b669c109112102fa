// SPDX-License-Identifier: BSD-3-Clause
//
// Frames of URDF files, in double. Internal to the reader of URDF.
#pragma once

#include <array>
#include <boost/qvm/map_mat_mat.hpp>
#include <boost/qvm/mat.hpp>
#include <boost/qvm/mat_operations.hpp>
#include <boost/qvm/vec.hpp>
#include <boost/qvm/vec_mat_operations.hpp>
#include <boost/qvm/vec_operations.hpp>

namespace kreisel::urdf {

using Vector = boost::qvm::vec<double, 3>;
using Matrix = boost::qvm::mat<double, 3, 3>;

inline Vector to_vector(const std::array<double, 3>& values) { return {values[0], values[1], values[2]}; }
inline Matrix identity() { return boost::qvm::identity_mat<double, 3>(); }

/// x = p + R x' of a point x' in the frame.
struct Pose {
    Matrix R = identity();
    Vector p = {0, 0, 0};
};

inline Pose operator*(const Pose& a, const Pose& b) { return {a.R * b.R, a.p + a.R * b.p}; }

class Element;

/// That of <origin>, which an element may lack.
Pose read_origin(const Element& element);

/// R_z(yaw) R_y(pitch) R_x(roll), of the angles (roll, pitch, yaw).
Matrix rotation_of(const std::array<double, 3>& rpy);

/// R J R^T of a symmetric J, symmetric to the last digit.
Matrix turned(const Matrix& R, const Matrix& J);

/// |d|^2 I - d d^T: the inertia of a unit mass at d.
Matrix of_unit_mass(const Vector& d);

}  // namespace kreisel::urdf
