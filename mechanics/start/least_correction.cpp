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
    MatX rows = C.transpose();
    for (Eigen::Index i = 0; i < rows.cols(); ++i)
        if (const Real norm = rows.col(i).norm(); norm > 0) rows.col(i) /= norm;
    qr.compute(rows);
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

/// The rows in the metric M and each by its scale: A = W C L^{-T}.
struct WeightedRows {
    VecX weights;
    MatX C, root, A;
    Eigen::Index rank;

    WeightedRows(StartState& start, Eigen::Index rows, const std::vector<bool>* coordinates)
        : weights(start.scale().head(rows).cwiseInverse()),
          C(weights.asDiagonal() * start.jacobian().topRows(rows)),
          root(mass_root(start)) {
        for (Eigen::Index k = 0; coordinates && k < C.cols(); ++k)
            if (!(*coordinates)[static_cast<std::size_t>(k)]) C.col(k).setZero();
        A = root.triangularView<Eigen::Lower>().solve(MatX(C.transpose())).transpose();
        rank = geometric_rank(start.model(), C);
    }
    VecX change(const VecX& residual) const {
        if (rank == 0) return VecX::Zero(C.cols());
        Eigen::CompleteOrthogonalDecomposition<MatX> solver;
        solver.setThreshold(threshold_of(rank, A));
        solver.compute(A);
        return root.transpose().triangularView<Eigen::Upper>().solve(
            VecX(solver.solve(VecX(-weights.cwiseProduct(residual.head(C.rows()))))));
    }
    /// Of each weighted coordinate, the square of its part in what the rows determine.
    VecX determined() const {
        if (rank == 0) return VecX::Zero(C.cols());
        const Eigen::ColPivHouseholderQR<MatX> qr(A.transpose());
        const MatX Q = qr.householderQ() * MatX::Identity(C.cols(), rank);
        return Q.rowwise().squaredNorm();
    }
};

}  // namespace

VecX least_correction(StartState& start, Eigen::Index rows, const VecX& residual) {
    return WeightedRows(start, rows, nullptr).change(residual);
}

/// Masses keep v and omega of each body apart, so that the metric does not mix given coordinates with others.
LeastCorrection least_correction(StartState& start, Eigen::Index rows, const VecX& residual,
                                 const std::vector<bool>& coordinates) {
    const WeightedRows weighted(start, rows, &coordinates);
    LeastCorrection result{weighted.change(residual), -weighted.rank,
                           VecX::Ones(weighted.C.cols()) - weighted.determined()};
    for (Eigen::Index k = 0; k < result.freedom.size(); ++k) {
        if (coordinates[static_cast<std::size_t>(k)])
            ++result.free;
        else
            result.freedom[k] = 0;
    }
    return result;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
