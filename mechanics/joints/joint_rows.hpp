// SPDX-License-Identifier: BSD-3-Clause
//
// The rows of a joint: those of the primitives in its recipe (mechanics/parts/joints/), in their order. With the points
// p of the two bodies, d = p_first - p_second, the axes a_k = R axes_k of the first body and b_k of the second (k = 1,
// 2, 3; a_3, b_3 along the axis of the joint), all in space axes:
//
//   coincidence       d = 0                                3 rows (N), space axes
//   along(k)          b_k.d = 0                            1 row (N)
//   orthogonal(i, k)  a_i.b_k = 0                          1 row (N m)
//   distance          |d| = L (1 + A sin(W t))             1 row (N)
//   shift             b_3.d + f(t) = 0                     1 row (N), f the prescribed shift
//   turn              f(t) - theta = 0                     1 row (N m), f the prescribed turn
//   helix             -2 pi b_3.d / lead - theta = 0       1 row (N m)
//   rack              2 pi a_3.d / lead - theta = 0        1 row (N m)
//   mesh              (z_1 psi_1 + z_2 psi_2)/z_2 = 0      1 row (N m)
//   contact           a_3.(P - p - c) = 0,  -a_k.(v_p + omega x c) = 0 (k = 1, 2, no position level)   3 rows (N)
//
// Each row is what the first body has minus what the second has, so that lambda of a row along e (a space axis, b_k,
// a_k of a contact) is the force lambda e on the second body, that of |d| a tension, and that of a_i.b_k the
// torque lambda a_i x b_k on the second body. The first gets the opposite.
// A contact is that of a disk of radius L, its centre p and its axis b_3 on the second body, on the plane through P
// with normal a_3 that the ground carries; c = -L s/|s| with s = a_3 - (a_3.b_3) b_3 leads from the centre to the
// contact. The three rows together say that the point of the disk in contact is at rest.
// a_1(f) = cos f a_1 + sin f a_2 is what b_1 is when the second body has turned by f about the axis. Of turn and helix
// the residual is the angle f - theta in (-pi, pi], theta the turn of the second body, as atan2(a_1(f).b_2,
// a_1(f).b_1): full turns need no count, and there is no second place half a turn away. The force of a multiplier
// lambda of a shift on the second body is lambda b_3, and the torque of a turn lambda b_3 where the axes are one: what
// drives the joint along and about its axis. A helix adds to its torque the force -lambda (2 pi / lead) b_3.
// A rack compares the second body with the frame that (a_3, -a_2) turned by f = 2 pi a_3.d / lead span in the first,
// so that the pinion turns with what the rack moves along a_3. In a mesh psi_1 is the angle of d in (a_1, a_2), psi_2
// that in (b_1, b_2): the line of centres carries the wheels, wherever it goes. Numbers of teeth are whole, and the sum
// is taken modulo full turns: full turns of wheels need no count.
// Axis rows vanish for opposite axes too; a motion cannot pass from the one to the other.
// Sources: [haug1989, Sec. 9.4] for the kinds of rows (dot-1, dot-2, spherical, distance),
// [neimarkfufaev1972, Sec. III.3] for the disk.
#pragma once

#include "mechanics/joints/reaction.hpp"
#include "mechanics/model/model.hpp"
#include "mechanics/model/motion.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

inline constexpr int most_rows = 6;  ///< of one joint

/// Rows of a joint, in its order; the first `position_rows` of them have a position level.
inline int rows_of(JointType type) { return type->row_count; }
inline int position_rows_of(JointType type) { return type->position_count; }
/// Whether all joints of a model only hold two points together.
bool all_spherical(const Model& model);

using Mat6 = Eigen::Matrix<Real, 6, 6>;
using Vec6 = Eigen::Matrix<Real, 6, 1>;

/// The rows of a joint at (t, q, v). Column k of `first` and `second` is row k of C with respect to (V, omega) of that
/// body, or the force and the torque in body axes that make up C^T; those of the ground are not used.
///   C v + b = first^T (V, omega) + second^T (V, omega) + rate_bias
///   d/dt (C v + b) = first^T (A, omega') + second^T (A, omega') + acceleration_bias,  A = R^T x''
struct JointRows {
    int count = 0;
    Mat6 first, second;
    Vec6 phi, rate_bias, acceleration_bias;
};

/// Fills `rows`; entries beyond `count` are left unchanged. The motion of the ground is Motion().
void write_rows(const Joint& joint, const Real& t, const Motion& first, const Motion& second, JointRows& rows);

/// Rows that compare directions have no unit; their multipliers are torques.
inline bool is_direction_row(JointType type, int row) { return row >= type->length_count; }
inline bool has_direction_rows(JointType type) { return is_direction_row(type, rows_of(type) - 1); }

/// The rows of C of a model: joints in its order, rows without a position level after all others.
std::vector<ConstraintRow> constraint_rows(const Model& model);

/// The wrench of a joint for given multipliers of its rows, in its order, and apart from it what drives the joint.
JointReaction reaction_of(const Joint& joint, const Real& t, const Motion& first, const Motion& second,
                          const Real* lambda);

/// Scale of a row: the joint's length (m, mechanics/model/scales.hpp), 1 for rows that compare directions. Residuals
/// are large or small relative to it, and rows divided by it are all of one unit.
Real row_scale(const Model& model, const Joint& joint, int row);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
