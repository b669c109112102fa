// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/solve/rank.hpp"

#include <Eigen/QR>
#include <Eigen/SparseQR>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr Eigen::Index most_dense_columns = 400;

RowChoice choose_dense(const MatX& A, int most) {
    const Eigen::ColPivHouseholderQR<MatX> qr(A);
    const auto pivot = [&](int i) { return Real(abs(qr.matrixQR()(i, i))); };
    RowChoice choice;
    choice.independent.assign(static_cast<std::size_t>(A.cols()), false);
    const int limit = min(most, static_cast<int>(min(A.rows(), A.cols())));
    while (choice.rank < limit && pivot(choice.rank) > dependence * pivot(0))
        choice.independent[static_cast<std::size_t>(qr.colsPermutation().indices()[choice.rank++])] = true;
    return choice;
}

RowChoice choose_sparse(const MatX& A, int most) {
    Eigen::SparseMatrix<Real> matrix = A.sparseView();
    matrix.makeCompressed();
    Eigen::SparseQR<Eigen::SparseMatrix<Real>, Eigen::COLAMDOrdering<int>> qr;
    qr.setPivotThreshold(dependence);
    qr.compute(matrix);
    RowChoice choice;
    choice.independent.assign(static_cast<std::size_t>(A.cols()), false);
    choice.rank = min(static_cast<int>(qr.rank()), most);
    for (int i = 0; i < choice.rank; ++i)
        choice.independent[static_cast<std::size_t>(qr.colsPermutation().indices()[i])] = true;
    return choice;
}

}  // namespace

RowChoice choose_rows(const MatX& A, int most) {
    if (A.cols() == 0) return {};
    const MatX scaled = A.colwise().normalized();
    return scaled.cols() > most_dense_columns ? choose_sparse(scaled, most) : choose_dense(scaled, most);
}

Real pivot_ratio(const MatX& A) {
    const Eigen::ColPivHouseholderQR<MatX> qr(A.colwise().normalized());
    const Eigen::Index last = A.cols() - 1;
    if (last >= A.rows()) return std::numeric_limits<Real>::infinity();
    return abs(qr.matrixQR()(0, 0)) / abs(qr.matrixQR()(last, last));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
