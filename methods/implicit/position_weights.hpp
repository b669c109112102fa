// SPDX-License-Identifier: BSD-3-Clause
//
// What the multipliers eta of a stabilised step and its residuals Phi are measured by. An eta has the size of the
// velocity that it makes: its weight is sqrt(s_ii M_11) / M_11, s_ii the diagonal entry of C M^{-1} C^T, times the
// `balance` of what positions and motion are known to, because what eta corrects is known only to round-off of
// places / h. Weights follow the motion in large steps, so that what an iteration has learnt stays valid.
#pragma once

#include "methods/implicit/motion_scale.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class PositionWeights {
  public:
    /// The system and the scale outlive this.
    PositionWeights(System& system, const MotionScale& scale);

    /// At (t, q), where the scale is known; forgets what was before.
    Status start(const Real& t, const Real* q);
    /// Rows turn with the bodies: with weights of other poses, an eta that moves much looks small. Returns whether that
    /// has changed, which is seen now and then.
    bool refresh(const Real& t, const Real* q);
    /// For steps by h of a motion of this size. Returns whether the balance has changed.
    bool rebalance(const Real& motion, const Real& h);

    /// The weight of each eta.
    auto weights() const { return balance_ * row_weights_; }
    /// Of multipliers at the level of velocities, which know nothing of places.
    const VecX& weights_of_velocities() const { return row_weights_; }
    /// Largest weighted entry of eta.
    Real of_eta(const VecX& eta) const { return row_weights_.cwiseProduct(eta).cwiseAbs().maxCoeff() * balance_; }
    /// Largest entry of Phi, each over the scale of its row.
    Real of_residual(const VecX& phi) const {
        return phi.head(positions_).cwiseQuotient(lengths_.head(positions_)).cwiseAbs().maxCoeff();
    }
    /// Largest velocity times h that corrects rows of the size of their terms.
    const Real& reach() const { return reach_; }
    /// Size of the places that Phi is known from, as a size of unknowns beside the motion.
    Real of_places(const Real& h) const { return balance_ * reach_ / abs(h); }
    /// Size of positions over that of the joints: how round-off of places affects directions.
    const Real& remoteness() const { return remoteness_; }

  private:
    void weigh_rows(const Real& t, const Real* q, VecX& weights) const;

    System& system_;
    const MotionScale& scale_;
    Eigen::Index m_, positions_;
    VecX row_weights_, lengths_, rows_;  // m
    VecX zero_, shift_;                  // n
    Real reach_ = 0;
    Real remoteness_ = 1, balance_ = 0;
    long steps_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
