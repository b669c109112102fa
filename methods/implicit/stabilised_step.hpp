// SPDX-License-Identifier: BSD-3-Clause
//
// What implicit methods with multipliers share: the end of a step from the stabilised index-2 form of the equations of
// motion [gear1985], [arnold2016]. A method specifies how velocity and increment depend on x = h v' at the end,
//   v+ = a x + v^,   q+ = q exp(h D),   D = b x + D^ - M^{-1} C(q)^T eta,
// and at t+ = t + h
//   h (M v'+ + C^T lambda - Q) = 0,   Phi(t+, q+) = 0,   C(t+, q+) v+ + b(t+, q+) = 0.
// The literature's term is C^T eta, which equates metres and radians: with levers of hundreds of metres it corrects
// positions by turning bodies. In the mass metric it is independent of units; eta vanishes along the exact flow, so the
// orders are unchanged. Rows without a position level have no Phi: for them C(q+) M^{-1} C(q)^T eta = 0.
//
// Unknowns of the iteration are x and eta. A guess gives q+, v+ and the forces there, and with one factorisation of the
// KKT matrix at (t+, q+) two solves give the next one,
//   [M C+^T; C+ 0] (x', h lambda) = (h Q, -(b+ + C+ v^) / a),
//   [M C+^T; C+ 0] (., eta - eta') = (0, C+ b (x' - x) + Phi / h),
// a contraction by O(h) where nothing is stiff; methods/implicit/newton/newton.hpp takes it from there. Nothing of this
// is more than linear in the bodies of a tree, redundant rows are those of System::solve_kkt, and sizes keep theirs as
// h goes to zero.
#pragma once

#include "methods/implicit/motion_scale.hpp"
#include "methods/implicit/newton/newton.hpp"
#include "methods/implicit/position_weights.hpp"
#include "methods/implicit/predictor.hpp"
#include "methods/implicit/stabilised_equations.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The relations of the method are to be set before `advance`.
class StabilisedStep final : public StepRelations, private Equations {
  public:
    explicit StabilisedStep(System& system);

    /// Fresh guesses from the index-1 form at (t, y); discards the memory of earlier steps. `rate` becomes h v'.
    Status start(const Real& t, const Real& h, const Real* y);
    /// y(t) -> y(t + h) in place; y is unchanged unless the status is ok.
    Status advance(const Real& t, const Real& h, Real* y);

    const VecX& rate() const { return end_.rate; }              ///< h v' at the end of the last step, or at the start
    const VecX& increment() const { return end_.increment(); }  ///< D of the last step
    /// lambda at the end of the last step (N), of least norm where rows are redundant.
    const Real* multipliers() const;
    long iterations() const { return newton_.iterations(); }  ///< of Newton's method, since construction

  private:
    Status residual(const Real* turned, Real* r) override;
    Real size() const override { return size_; }
    Real round_off() const override { return weights_of_positions_.remoteness() * system_.kkt_round_off(); }

    void weigh_unknowns();
    void guess();
    Status iterate();
    Status find_cause();
    Status settle_positions();
    Status settle_rate();
    /// What the next guess is made from.
    void remember();
    void accept(Real* y);

    /// Unknowns x, eta from those of the iteration.
    void take(const Real* turned);
    bool moves_positions() const { return weights_of_positions_.of_eta(end_.change) > 64 * epsilon * size_; }
    Real position_defect() { return weights_of_positions_.of_residual(end_.position_residual()); }

    System& system_;
    StabilisedEquations end_;
    Eigen::Index n_, etas_;
    MotionScale scale_;
    PositionWeights weights_of_positions_;
    Newton newton_;
    Predictor past_;                    // of turned_
    VecX unknowns_, turned_, weights_;  // x, eta; the same with x weighted and in space axes
    VecX difference_;                   // n
    mutable VecX lambda_;
    mutable bool least_norm_ = true;
    Real h_ = 0, speed_ = 0, size_ = 0;
    const Real* q_ = nullptr;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
