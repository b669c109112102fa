// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/taylor_complement.hpp"

#include <Eigen/QR>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Below this ratio of pivots a row counts as dependent: a start may violate its joints by 1e-9.
const Real dependence = Real(1) / 10000000;
/// Pivots of S are squares of those, except for the masses: below this fraction of its diagonal, rank is determined
/// anew.
const Real doubtful = Real(1) / 10000000000;

/// Of each body: its radius of gyration or its longest arm to a joint.
std::vector<Real> lengths_of(const Model& model, const std::vector<BodySeries>& bodies) {
    std::vector<Real> lengths;
    for (const BodySeries& body : bodies) lengths.push_back(body.radius());
    for (const Joint& joint : model.joints)
        for (const auto& [body, arm] : {std::pair(joint.first, joint.r_first), std::pair(joint.second, joint.r_second)})
            if (body != ground) {
                Real& length = lengths[static_cast<std::size_t>(body)];
                length = max(length, Real(arm.norm()));
            }
    return lengths;
}

}  // namespace

TaylorComplement::TaylorComplement(const Model& model, const std::vector<BodySeries>& bodies,
                                   const std::vector<JointSeries>& joints)
    : bodies_(bodies), joints_(joints), lengths_(lengths_of(model, bodies)) {
    for (std::size_t j = 0; j < joints.size(); ++j)
        for (int row = 0; row < joints[j].rows(); ++row) rows_.push_back({j, row, joints[j].scale(row)});
    A_.resize(6 * static_cast<Eigen::Index>(model.bodies.size()), static_cast<Eigen::Index>(rows_.size()));
}

template <class F>
void TaylorComplement::each_side(const Row& row, F f) const {
    const JointSeries& joint = joints_[row.joint];
    f(joint.first(), joint.on_first(row.row)), f(joint.second(), joint.on_second(row.row));
}

bool TaylorComplement::factor() {
    assemble();
    if ((factored_ = rank_ == A_.cols() && factor_complement() > doubtful)) return true;
    const Eigen::Index rank = geometric_rank();
    if (rank_ < 0) rank_ = rank;
    if (rank != rank_) return false;
    if ((factored_ = rank == A_.cols() && factor_complement() > 0)) return true;
    return pseudoinvert(rank);
}

void TaylorComplement::assemble() {
    A_.setZero();
    for (std::size_t c = 0; c < rows_.size(); ++c)
        each_side(rows_[c], [&](const BodySeries& body, const JointSeries::Wrench& wrench) {
            if (body.is_fixed()) return;
            A_.block<6, 1>(place(body), static_cast<Eigen::Index>(c)) +=
                body.weighted(wrench.force, wrench.moment) / rows_[c].scale;
        });
}

/// S = L L^T, entry by entry: most joints share no body. Returns the smallest pivot relative to its diagonal entry, not
/// positive where there are no factors.
Real TaylorComplement::factor_complement() {
    MatX S = MatX::Zero(A_.cols(), A_.cols());
    const auto share = [&](std::size_t a, std::size_t b, Eigen::Index i, Eigen::Index j) {
        for (const BodySeries* body : {&joints_[a].first(), &joints_[a].second()}) {
            if (body->is_fixed() || (body != &joints_[b].first() && body != &joints_[b].second())) continue;
            S(i, j) += A_.block<6, 1>(place(*body), i).dot(A_.block<6, 1>(place(*body), j));
        }
    };
    for (Eigen::Index i = 0; i < S.rows(); ++i)
        for (Eigen::Index j = 0; j <= i; ++j)
            share(rows_[static_cast<std::size_t>(i)].joint, rows_[static_cast<std::size_t>(j)].joint, i, j);
    cholesky_.compute(S);
    const auto& L = cholesky_.matrixLLT();
    if (cholesky_.info() != Eigen::Success) return 0;
    Real smallest = 1;
    for (Eigen::Index i = 0; i < S.rows(); ++i) smallest = min(smallest, Real(L(i, i) * L(i, i) / S(i, i)));
    return smallest;
}

/// Of A at this rank. False where its own pivots do not agree with the rank.
bool TaylorComplement::pseudoinvert(Eigen::Index rank) {
    if (rank == 0) {
        inverse_.setZero(A_.cols(), A_.rows());
        return true;
    }
    Eigen::CompleteOrthogonalDecomposition<MatX> decomposition(A_.rows(), A_.cols());
    const auto pivot = [&, qr = Eigen::ColPivHouseholderQR<MatX>(A_)](Eigen::Index i) {
        return i < min(A_.rows(), A_.cols()) ? Real(abs(qr.matrixQR()(i, i))) : Real(0);
    };
    decomposition.setThreshold((pivot(rank - 1) + pivot(rank)) / (2 * pivot(0)));
    decomposition.compute(A_);
    inverse_ = decomposition.pseudoInverse();
    return decomposition.rank() == rank;
}

/// Of C^T with torques over lengths of their bodies and columns of length 1: independent of masses and units.
Eigen::Index TaylorComplement::geometric_rank() const {
    MatX C = MatX::Zero(A_.rows(), A_.cols());
    for (std::size_t c = 0; c < rows_.size(); ++c)
        each_side(rows_[c], [&](const BodySeries& body, const JointSeries::Wrench& wrench) {
            if (body.is_fixed()) return;
            const Real& length = lengths_[static_cast<std::size_t>(&body - bodies_.data())];
            Eigen::Matrix<Real, 6, 1> both;
            both << wrench.force, wrench.moment / (length > 0 ? length : Real(1));
            C.block<6, 1>(place(body), static_cast<Eigen::Index>(c)) += both;
        });
    Eigen::ColPivHouseholderQR<MatX> qr;
    qr.setThreshold(dependence);
    qr.compute(C.colwise().normalized());
    return qr.rank();
}

VecX TaylorComplement::solve(const VecX& residual) const {
    return factored_ ? VecX(cholesky_.solve(residual)) : VecX(inverse_ * (inverse_.transpose() * residual));
}

VecX TaylorComplement::terms() const {
    VecX sizes = VecX::Zero(A_.cols());
    for (std::size_t c = 0; c < rows_.size(); ++c)
        each_side(rows_[c], [&](const BodySeries& body, const JointSeries::Wrench& wrench) {
            if (body.is_fixed()) return;
            sizes[static_cast<Eigen::Index>(c)] +=
                (wrench.force.norm() * body.acceleration_size() + wrench.moment.norm() * body.turning_size()) /
                    rows_[c].scale +
                body.omega[0].squaredNorm();
        });
    return sizes;
}

bool TaylorComplement::contradicts(const VecX& residual) const {
    if (rank_ == A_.cols()) return false;
    const Real rest = (residual - A_.transpose() * (inverse_.transpose() * residual)).norm();
    return rest > (residual.norm() + terms().norm()) / 1000000;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
