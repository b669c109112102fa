// SPDX-License-Identifier: BSD-3-Clause
//
// The end of a step from the index-3 form of the equations of motion, with only the constraints on positions
// [bruelscardona2010]. A method specifies how velocity and increment depend on x = h v' at the end,
//   v+ = a x + v^,   q+ = q exp(h D),   D = b x + D^,
// and at t+ = t + h
//   h (M v'+ + C^T lambda - Q) = 0,   Phi(t+, q+) = 0.
// Rows without a position level are met as C(t+, q+) v+ + b(t+, q+) = 0.
//
// The unknown of the iteration is x. A guess gives q+, v+ and the forces there, and the KKT matrix at (t+, q+) the next
// one,
//   [M C+^T; C+ 0] (x', h lambda) = (h Q, C+ x - Phi / (h b)),
// a contraction by O(h) where nothing is stiff (methods/implicit/newton/newton.hpp). What the form costs is round-off:
// positions are known to eps |q|, hence v to eps |q| / h and multipliers to eps M |q| / h^2 [arnold2015].
#pragma once

#include <vector>

#include "methods/implicit/motion_scale.hpp"
#include "methods/implicit/newton/newton.hpp"
#include "methods/implicit/position_weights.hpp"
#include "methods/implicit/predictor.hpp"
#include "methods/implicit/stabilised_equations.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The relations of the method are to be set before `advance`; used like StabilisedStep.
class PositionStep final : public StepRelations, private Equations {
  public:
    explicit PositionStep(System& system);

    /// Fresh guesses from the index-1 form at (t, y); discards the memory of earlier steps. `rate` becomes h v'.
    Status start(const Real& t, const Real& h, const Real* y);
    /// y(t) -> y(t + h) in place; y is unchanged unless the status is ok.
    Status advance(const Real& t, const Real& h, Real* y);

    const VecX& rate() const { return x_; }               ///< h v' at the end of the last step, or at the start
    const VecX& increment() const { return increment_; }  ///< D of the last step
    /// lambda at the end of the last step (N), of least norm where rows are redundant.
    const Real* multipliers() const;
    long iterations() const { return newton_.iterations(); }  ///< of Newton's method, since construction

  private:
    Status residual(const Real* turned, Real* r) override;
    Real size() const override { return size_; }
    Real round_off() const override { return weights_of_positions_.remoteness() * system_.kkt_round_off(); }

    void guess();
    Status iterate();
    Status find_cause();
    void settle();
    void place();
    void evaluate_forces();
    void set_rows();
    void remember();
    void accept(Real* y);

    System& system_;
    Eigen::Index n_, m_, positions_;
    MotionScale scale_;
    PositionWeights weights_of_positions_;
    Newton newton_;
    Predictor past_;                                                                // of turned_
    VecX x_, turned_, weights_, rate_, velocity_, increment_, force_, gyroscopic_;  // n; turned_: x in space axes
    VecX rows_, phi_, impulse_;                                                     // m
    mutable VecX lambda_;
    mutable bool least_norm_ = true;
    std::vector<Real> configuration_;
    Real t_ = 0, end_ = 0, h_ = 0, speed_ = 0, size_ = 0;
    const Real* q_ = nullptr;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
