// SPDX-License-Identifier: BSD-3-Clause
//
// What implicit Runge-Kutta and Adams-Moulton methods on TG share: stages in coordinates of the group around q~,
//   Q_i = q~ exp(u_i),   u_i = u^ + h sum_j a_ij k_j (- theta/2),   k_i = dexp^{-1}_{-u_i}(V_i),
//   V_i = v + v^ + h sum_j a^_ij f_j,   f_i = v' of the index-1 form at (t + c_i h, Q_i, V_i),
//   q+ = q exp(theta),   theta = u^ + h sum_j b_j k_j,   v+ = v + v^ + h sum_j b_j f_j.
// q~ = q, the usual centre of Munthe-Kaas methods [munthekaas1999], or q~ = q exp(theta/2), which makes symmetric
// tableaus symmetric methods [zanna2001]; theta/2 is then taken from u_i. What is known beforehand, u^ and v^, is that
// of multistep methods.
//
// Unknowns of the iteration are the slopes k_i and w_i = h f_i (methods/implicit/newton.hpp); the last f_i make the
// step: what is linear in the constraints then holds to the round-off of one solve.
#pragma once

#include <vector>

#include "methods/implicit/motion_scale.hpp"
#include "methods/implicit/newton.hpp"
#include "methods/implicit/predictor.hpp"
#include "methods/implicit/remoteness.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The same a for positions and velocities is one method, others make a partitioned one.
struct StageCoefficients {
    MatX a, a_hat;  ///< s x s: of positions, of velocities
    VecX b, c;      ///< s
};

enum class StageCentre { start, middle };

class ImplicitStages final : private Equations {
  public:
    ImplicitStages(System& system, StageCoefficients coefficients, StageCentre centre);

    /// Discards the memory of earlier steps.
    void forget() { newton_.forget(), scale_.forget(), past_.clear(); }
    /// y(t) -> y(t + h) in place; y is unchanged unless the status is ok.
    Status advance(const Real& t, const Real& h, Real* y);
    long iterations() const { return newton_.iterations(); }  ///< of Newton's method, since construction

    VecX position_offset, velocity_offset;  ///< u^, v^ of the next step, or empty: none. Around q only.

  private:
    Status residual(const Real* turned, Real* r) override;
    Real size() const override;
    Real round_off() const override { return remoteness_ * system_.kkt_round_off(); }

    Status guess();
    Status iterate();
    void find_centre();
    void place(Eigen::Index i);
    Status renew_slopes(Real* of_positions);
    Status stage(Eigen::Index i, Real* of_position, Real* of_velocity);
    void accept(Real* y);
    bool has_offsets() const { return position_offset.size() > 0; }
    /// k_i and w_i among the unknowns.
    Real* slope_of_position(Eigen::Index i) { return turned_.data() + i * n_; }
    Real* slope_of_velocity(Eigen::Index i) { return turned_.data() + (stages_ + i) * n_; }

    System& system_;
    const StageCoefficients coefficients_;
    const bool around_middle_;
    Eigen::Index n_, stages_;
    Newton newton_;
    MotionScale scale_;
    Remoteness remoteness_of_;
    Predictor past_;                        // of turned_
    VecX turned_, weights_;                 // all k_i, then all w_i, in space axes
    MatX k_, w_, f_, renewed_;              // a column a stage
    VecX half_, u_, stage_v_, difference_;  // half_: theta/2, or 0 around q
    std::vector<Real> centre_, stage_q_;
    Real t_ = 0, h_ = 0, known_h_ = 0, motion_ = 0, remoteness_ = 1;
    const Real *q_ = nullptr, *v_ = nullptr;  // start of the step
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
