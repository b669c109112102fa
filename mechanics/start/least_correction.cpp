// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/start/least_correction.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "mechanics/model/scales.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// L of M = L L^T, masses in the mechanism's unit.
MatX mass_root(StartState& start) {
    const System& system = start.system();
    const Eigen::Index n = start.velocity_coordinates();
    std::vector<Real> blocks(static_cast<std::size_t>(n * system.mass_block()));
    system.mass(start.q(), blocks.data());
    MatX root = MatX::Zero(n, n);
    const Real unit = mass_unit(start.model());
    for (Eigen::Index i = 0; i < n; i += 6) {
        const Mat6 M = Eigen::Map<const Mat6>(&blocks[static_cast<std::size_t>(6 * i)]) / unit;
        root.block<6, 6>(i, i) = M.llt().matrixL();
    }
    return root;
}

/// Rank of C, torques divided by lengths and rows by their norms: independent of masses and units.
Eigen::Index geometric_rank(const Model& model, MatX C) {
    const std::vector<Real> lengths = body_lengths(model);
    for (std::size_t i = 0; i < lengths.size(); ++i)
        if (lengths[i] > 0) C.middleCols(6 * static_cast<Eigen::Index>(i) + 3, 3) /= lengths[i];
    Eigen::ColPivHouseholderQR<MatX> qr;
    qr.setThreshold(Real(1) / 1000000);
    qr.compute(MatX(C.transpose()).colwise().normalized());
    return qr.rank();
}

/// A threshold between the pivots of A that yields this rank.
Real threshold_of(Eigen::Index rank, const MatX& A) {
    const Eigen::ColPivHouseholderQR<MatX> qr(A);
    const auto pivot = [&](Eigen::Index i) {
        return i < min(A.rows(), A.cols()) ? Real(abs(qr.matrixQR()(i, i))) : Real(0);
    };
    return (pivot(rank - 1) + pivot(rank)) / (2 * qr.maxPivot());
}

}  // namespace

VecX least_correction(StartState& start, Eigen::Index rows, const VecX& residual) {
    const VecX weights = start.scale().head(rows).cwiseInverse();
    const MatX C = weights.asDiagonal() * start.jacobian().topRows(rows), root = mass_root(start);
    const auto L = root.triangularView<Eigen::Lower>();
    const MatX A = L.solve(MatX(C.transpose())).transpose();
    const Eigen::Index rank = geometric_rank(start.model(), C);
    if (rank == 0) return VecX::Zero(start.velocity_coordinates());
    Eigen::CompleteOrthogonalDecomposition<MatX> solver;
    solver.setThreshold(threshold_of(rank, A));
    solver.compute(A);
    return root.transpose().triangularView<Eigen::Upper>().solve(
        VecX(solver.solve(VecX(-weights.cwiseProduct(residual.head(rows))))));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
