// SPDX-License-Identifier: BSD-3-Clause
//
// What a body and all that hangs on it show at the joint to its parent (mechanics/formulations/spherical_bodies.hpp has
// the equations): gathered from the children, then reduced to the apparent mass.
#pragma once

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// R hat(r)^T: column k is R (e_k x r).
inline Mat3 arm(const auto& R, const Vec3& r) {
    Mat3 A;
    A << r[1] * R.col(2) - r[2] * R.col(1), r[2] * R.col(0) - r[0] * R.col(2), r[0] * R.col(1) - r[1] * R.col(0);
    return A;
}

/// R (omega x (omega x r)).
inline Vec3 centripetal(const auto& R, const Vec3& omega, const Vec3& r) { return R * omega.cross(omega.cross(r)); }

/// D^{-1} = adjugate / determinant of a symmetric D: products with the adjugate need not wait for the division.
struct SymmetricInverse {
    explicit SymmetricInverse(const Mat3& D) {
        const Vec3 c0 = D.col(1).cross(D.col(2)), c1 = D.col(2).cross(D.col(0));
        adjugate << c0[0], c0[1], c0[2], c0[1], c1[1], c1[2], c0[2], c1[2], D(0, 0) * D(1, 1) - D(0, 1) * D(0, 1);
        factor = 1 / D.col(0).dot(c0);
    }
    Mat3 adjugate;
    Real factor;
};

/// a with M a + f = 0.
inline Vec3 free_acceleration(const Mat3& M, const Vec3& f) {
    const SymmetricInverse inverse(M);
    return -inverse.factor * (inverse.adjugate * f);
}

/// D, B and M of a body while its children are added.
struct ArticulatedInertia {
    /// Without children: D = J, B = m X, M = m I.
    ArticulatedInertia(const Mat3& J, const Real& m, const Mat3& X) : D(J), B(m * X), M(m * Mat3::Identity()) {}

    /// D += Z^T M_c Z, B += M_c Z, M += M_c.
    void add_child(const Mat3& M_c, const Mat3& Z) {
        const Mat3 Y = M_c * Z;
        for (int j = 0; j < 3; ++j)  // Z^T Y is symmetric
            for (int i = j; i < 3; ++i) D(j, i) = D(i, j) += Z.col(i).dot(Y.col(j));
        B += Y, M += M_c;
    }

    /// M -= B D^{-1} B^T, where H = B adjugate(D).
    void reduce(const Mat3& H, const Real& factor) {
        for (int j = 0; j < 3; ++j)
            for (int i = j; i < 3; ++i) M(j, i) = M(i, j) -= factor * H.row(i).dot(B.row(j));
    }

    Mat3 D, B, M;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
