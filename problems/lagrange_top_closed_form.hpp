// SPDX-License-Identifier: BSD-3-Clause
//
// The symmetric heavy top (Lagrange's top) in closed form: Jacobi elliptic functions for the inclination of its axis,
// elliptic integrals of the third kind for precession and spin [goldstein2002, Sec. 5.7]; and its steady precession.
#pragma once

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A body that rotates about a fixed point and is symmetric about the line from there to its mass centre.
struct LagrangeTop {
    Real transverse, axial;  ///< moments of inertia A, C about the fixed point, kg m^2
    Vec3 axis;               ///< unit vector from the fixed point to the mass centre, body axes
    Vec3 up;                 ///< unit vector against gravity, space axes
    Real moment;             ///< mass times gravity times distance of the mass centre, N m
};

/// `lever`: fixed point to mass centre, body axes, m; `gravity`: space axes, m/s^2. Throws std::domain_error where the
/// body is not symmetric about its lever to 1024 epsilon, or has no lever, or there is no gravity.
LagrangeTop lagrange_top(const Body& body, const Vec3& lever, const Vec3& gravity);

struct TopState {
    Mat3 R;      ///< body to space
    Vec3 omega;  ///< body axes, rad/s
};

/// Rotation and angular velocity at time t (s). Throws std::domain_error for a motion in which the axis passes through
/// the vertical: there the angles of precession and spin are not defined.
TopState lagrange_motion(const LagrangeTop& top, const TopState& start, const Real& t);

/// Angular velocities about the upward vertical and about the axis, rad/s.
struct SteadyPrecession {
    Real precession, spin;
};

/// The slower and the faster steady precession of a top with attitude R that turns at `axial` (rad/s) about its axis:
/// the roots Omega of A cos(theta) Omega^2 - C axial Omega + moment = 0, and spin = axial - Omega cos(theta). Throws
/// std::domain_error if there is none, or if the axis is horizontal and the faster one is requested.
SteadyPrecession slow_precession(const LagrangeTop& top, const Mat3& R, const Real& axial);
SteadyPrecession fast_precession(const LagrangeTop& top, const Mat3& R, const Real& axial);

/// R(t) = exp(Omega t up) R exp(spin t axis).
TopState steady_motion(const LagrangeTop& top, const SteadyPrecession& motion, const Mat3& R, const Real& t);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
