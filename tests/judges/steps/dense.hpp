// SPDX-License-Identifier: BSD-3-Clause
//
// The calculus of matrix groups done with dense matrices only: exponentials by scaling and squaring of the
// Taylor series, brackets as commutators, dexpinv as the inverse of a matrix series. Slow, and independent of lie/
// except for its storage.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "lie/group.hpp"
#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A group as square matrices; hat and vee between R^n and its matrix algebra.
struct MatrixGroup {
    std::string name;
    std::shared_ptr<const Group> group;
    std::function<MatX(const VecX&)> hat;
    std::function<VecX(const MatX&)> vee;
    std::function<MatX(const Real*)> matrix;  ///< of a stored element
};

MatrixGroup matrix_so3();
MatrixGroup matrix_so3xr3();
/// Rotations by the matrices of their quaternions.
MatrixGroup matrix_s3();
MatrixGroup matrix_s3xr3();
MatrixGroup matrix_se3();
/// T*SO(3) in space axes: SE(3) with R m as the translation.
MatrixGroup matrix_cotangent_so3();

MatX dense_exp(const MatX& a);
/// u with exp(u) = a, for rotations by less than pi.
MatX dense_log(const MatX& a);
/// (I - a/2)^{-1} (I + a/2).
MatX dense_cay(const MatX& a);

/// Matrix of ad_u in the coordinates of the algebra, from commutators.
MatX dense_ad(const MatrixGroup& g, const VecX& u);

/// u' for q = q0 exp(u), q' = q hat(v): solves v = sum_k (-ad_u)^k/(k+1)! u'.
VecX dense_dexpinv_left(const MatrixGroup& g, const VecX& u, const VecX& v);
/// The series sum_p (-1)^p B_p/p! ad_u^p v up to p = brackets.
VecX dense_truncated_dexpinv_left(const MatrixGroup& g, const VecX& u, const VecX& v, int brackets);
/// u' for q = q0 cay(u), q' = q hat(v): hat(u') = (I + hat(u)/2) hat(v) (I - hat(u)/2).
VecX dense_dcayinv_left(const MatrixGroup& g, const VecX& u, const VecX& v);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
