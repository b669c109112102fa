// SPDX-License-Identifier: BSD-3-Clause
#include "methods/projection/least_corrections.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class LeastInMass final : public Correction {
  public:
    explicit LeastInMass(System& system) : system_(system) {}
    Status solve(const Real& t, const Real* q, const Real* c, Real* delta) override {
        return system_.solve_kkt(t, q, nullptr, c, delta, nullptr);
    }

  private:
    System& system_;
};

/// By Gram-Schmidt on the rows, the one with the longest remainder next: C_k = L Q with Q Q^T = I for the rows taken,
/// so L y = c_k and delta = Q^T y. A row that depends on those taken is not taken.
class LeastInCoordinates final : public Correction {
  public:
    explicit LeastInCoordinates(System& system)
        : system_(system),
          rows_(system),
          Q_(system.velocities(), system.constraints()),
          L_(MatX::Zero(system.constraints(), rows_.rank)),
          right_(system.constraints()),
          y_(rows_.rank) {}

    Status solve(const Real& t, const Real* q, const Real* c, Real* delta) override {
        if (!rows_.evaluate(system_, t, q)) return Status::non_finite;
        prepare(c);
        Eigen::Map<VecX> sum(delta, Q_.rows());
        sum.setZero();
        Real first = 0;
        for (Eigen::Index k = 0; k < rows_.rank; ++k) {
            const Real pivot = take(k);
            if (k == 0) first = pivot;
            if (!(pivot > dependent_pivot * first)) return Status::singular_kkt;
            Real y = right_[k];
            for (Eigen::Index j = 0; j < k; ++j) y -= L_(k, j) * y_[j];
            y_[k] = y / pivot;
            sum += y_[k] * Q_.col(k);
        }
        return Status::ok;
    }

  private:
    /// Rows as columns of length 1.
    void prepare(const Real* c) {
        Q_ = rows_.C.transpose();
        for (Eigen::Index i = 0; i < Q_.cols(); ++i) {
            const Real length = Q_.col(i).norm();
            right_[i] = length > 0 ? Real(c[i] / length) : Real(0);
            if (length > 0) Q_.col(i) /= length;
        }
    }

    /// Row k becomes the one with the longest remainder, normed; it is taken out of those after it. Returns its length.
    Real take(Eigen::Index k) {
        Eigen::Index longest = k;
        Real square = 0;
        for (Eigen::Index i = k; i < Q_.cols(); ++i)
            if (const Real size = Q_.col(i).squaredNorm(); size > square) square = size, longest = i;
        const Real length = sqrt(square);
        if (longest != k) {
            Q_.col(k).swap(Q_.col(longest));
            L_.row(k).swap(L_.row(longest));
            std::swap(right_[k], right_[longest]);
        }
        if (length > 0) Q_.col(k) /= length;
        for (Eigen::Index i = k + 1; i < Q_.cols(); ++i) {
            L_(i, k) = Q_.col(i).dot(Q_.col(k));
            Q_.col(i) -= L_(i, k) * Q_.col(k);
        }
        return length;
    }

    System& system_;
    DenseRows rows_;
    MatX Q_, L_;
    VecX right_, y_;
};

}  // namespace

std::unique_ptr<Correction> least_in_mass(System& system) { return std::make_unique<LeastInMass>(system); }

std::unique_ptr<Correction> least_in_coordinates(System& system) {
    return std::make_unique<LeastInCoordinates>(system);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
