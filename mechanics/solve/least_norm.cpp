// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/solve/least_norm.hpp"

#include <Eigen/QR>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::vector<Eigen::Index> dropped_rows(const RowSelection& selection, Eigen::Index rows) {
    std::vector<Eigen::Index> dropped;
    for (Eigen::Index i = 0; i < rows; ++i)
        if (!selection.is_kept(i)) dropped.push_back(i);
    return dropped;
}

/// C M^{-1} C^T e_row.
VecX complement_column(const ConstraintMatrix& C, Eigen::Index row) {
    VecX unit = VecX::Zero(C.size()), column = unit;
    unit[row] = 1;
    std::vector<Vec6> a(C.bodies(), Vec6::Zero());
    for (const ConstraintMatrix::End& end : C.ends()) {
        const int n = C.rows(end.joint);
        a[end.body] += end.mobility.leftCols(n) * unit.segment(C.at(end.joint, 0), n);
    }
    for (const ConstraintMatrix::End& end : C.ends()) {
        const int n = C.rows(end.joint);
        column.segment(C.at(end.joint, 0), n) += end.W->leftCols(n).transpose() * a[end.body];
    }
    return column;
}

}  // namespace

void LeastNorm::minimise(const ConstraintMatrix& C, const RowSelection& selection, const VecX& scale, Complement& S,
                         VecX& lambda) {
    const std::vector<Eigen::Index> dropped = dropped_rows(selection, C.size());
    MatX N(C.size(), static_cast<Eigen::Index>(dropped.size()));
    for (Eigen::Index c = 0; c < N.cols(); ++c) {
        const Eigen::Index row = dropped[static_cast<std::size_t>(c)];
        VecX column = complement_column(C, row);
        for (const Eigen::Index i : dropped) column[i] = 0;
        S.solve(column);
        const VecX unit = VecX::Unit(C.size(), row);
        N.col(c) = scale.asDiagonal() * (column - unit) / scale[row];  // free of units
    }
    const Eigen::HouseholderQR<MatX> factors(N);
    const MatX U = factors.householderQ() * MatX::Identity(N.rows(), N.cols());
    share_ = U.rowwise().norm();
    const VecX scaled = scale.asDiagonal() * lambda;
    lambda -= scale.cwiseInverse().asDiagonal() * (U * (U.transpose() * scaled));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
