// SPDX-License-Identifier: BSD-3-Clause
//
// What implicit Runge-Kutta and Adams-Moulton methods on TG share: stages in coordinates of the group around q~,
//   Q_i = q~ exp(u_i),   u_i = u^ + h sum_j a_ij k_j (- theta/2),   k_i = dexp^{-1}_{-u_i}(V_i),
//   V_i = v + v^ + h sum_j a^_ij f_j,   f_i = v' of the index-1 form at (t + c_i h, Q_i, V_i),
//   q+ = q exp(theta),   theta = u^ + h sum_j b_j k_j,   v+ = v + v^ + h sum_j b_j f_j.
// q~ = q, the usual centre of Munthe-Kaas methods [munthekaas1999], or q~ = q exp(theta/2), which makes symmetric
// tableaus symmetric methods [zanna2001]; theta/2 is then taken from u_i. What is known beforehand, u^ and v^, is that
// of multistep methods. Where another group acts on states (mechanics/actions/state_action.hpp), y takes the place of
// q, (k_i, f_i) are the two halves of a slope in its algebra, and brackets reach both (acted_stages.hpp).
//
// Unknowns of the iteration are the slopes k_i and w_i = h f_i (methods/implicit/newton/newton.hpp); the last f_i make
// the step: what is linear in the constraints then holds to the round-off of one solve.
#pragma once

#include <memory>

#include "methods/implicit/motion_scale.hpp"
#include "methods/implicit/newton/newton.hpp"
#include "methods/implicit/predictor.hpp"
#include "methods/implicit/stages/remoteness.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The same a for positions and velocities is one method, others make a partitioned one.
struct StageCoefficients {
    MatX a, a_hat;  ///< s x s: of positions, of velocities
    VecX b, c;      ///< s
};

enum class StageCentre { start, middle };

/// The iteration; what a slope is, and how states move, is that of the group.
class ImplicitStages : protected Equations {
  public:
    ImplicitStages(System& system, StageCoefficients coefficients, StageCentre centre);

    /// Discards the memory of earlier steps.
    void forget() { newton_.forget(), scale_.forget(), past_.clear(); }
    /// y(t) -> y(t + h) in place; y is unchanged unless the status is ok.
    Status advance(const Real& t, const Real& h, Real* y);
    long iterations() const { return newton_.iterations(); }  ///< of Newton's method, since construction

    VecX position_offset, velocity_offset;  ///< u^, v^ of the next step, or empty: none. Around the start only.

  protected:
    /// v' at the start of the step, and f there.
    virtual Status slope_at_start(Real* rate, Real* f) = 0;
    /// y becomes the end of the step.
    virtual void accept(Real* y) = 0;

    bool has_offsets() const { return position_offset.size() > 0; }
    /// k_ and w_ of unknowns.
    void take(const Real* turned);
    /// Differences in k_i or w_i as residuals.
    void give(const VecX& difference, Real* r) const { scale_.to_space(y_, difference.data(), r); }

    System& system_;
    const StageCoefficients coefficients_;
    const bool around_middle_;
    const Eigen::Index n_, stages_;
    MatX k_, w_, f_;           // a column a stage
    VecX difference_;          // n
    Real t_ = 0, h_ = 0;       // of the step
    const Real* y_ = nullptr;  // start of the step

  private:
    Real size() const override;
    Real round_off() const override { return remoteness_ * system_.kkt_round_off(); }

    Status guess();
    Status iterate();
    /// k_i and w_i among the unknowns.
    Real* slope_of_position(Eigen::Index i) { return turned_.data() + i * n_; }
    Real* slope_of_velocity(Eigen::Index i) { return turned_.data() + (stages_ + i) * n_; }

    Newton newton_;
    MotionScale scale_;
    Remoteness remoteness_of_;
    Predictor past_;         // of turned_
    VecX turned_, weights_;  // all k_i, then all w_i, in space axes
    VecX rate_;
    Real known_h_ = 0, motion_ = 0, remoteness_ = 1;
};

/// In TG, or in the group that acts on the states of the system in its place.
std::unique_ptr<ImplicitStages> implicit_stages(System& system, StageCoefficients coefficients, StageCentre centre);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
