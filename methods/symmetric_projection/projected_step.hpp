// SPDX-License-Identifier: BSD-3-Clause
//
// The equations of a step between two equal projections (symmetric_projection.hpp), for given unknowns of the step
// proper, mu and nu: q~, v~, the middle of the step, q+, v+, and the residuals.
#pragma once

#include <vector>

#include "mechanics/system.hpp"
#include "methods/implicit/motion_scale.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Unknowns are x = (slopes, mu, nu): some vectors of n of the unit of velocities, and multipliers of m.
class ProjectedStep {
  public:
    /// Both outlive this.
    ProjectedStep(System& system, const MotionScale& scale, Eigen::Index slopes);
    virtual ~ProjectedStep() = default;
    ProjectedStep(const ProjectedStep&) = delete;
    ProjectedStep& operator=(const ProjectedStep&) = delete;

    Eigen::Index slopes() const { return slopes_; }
    Eigen::Index unknowns() const { return slopes_ * n_ + 2 * m_; }

    /// For a step from (q, v) at t by h.
    void begin(const Real& t, const Real& h, const Real* q, const Real* v);
    /// The slopes where h v' is constant.
    virtual void guess(const VecX& change, Real* slopes) const = 0;
    /// q~, v~, and q+ for x.
    void place(const Real* x);
    /// x - x' of a guess x: slopes' follow from the stages, and by the KKT matrix at the middle the mu' and nu' that
    /// they call for.
    Status residual(const Real* x, Real* r);
    /// The same for mu and nu with what the stages make of v~ held.
    Status correction(const Real* x, Real* r);
    /// Whether rows lose rank at q+.
    Status prepare() { return system_.prepare_kkt(end_, configuration_.data()); }

    const std::vector<Real>& configuration() const { return configuration_; }  ///< q+
    /// v+ = v~+ + G(q+) nu.
    const VecX& velocity(const Real* x);
    /// Largest h f of the last residual, as a velocity.
    virtual Real largest_change() const = 0;

  protected:
    /// middle_ and free_, q~+, from start_ and moved_.
    virtual void place_step(const Real* slopes) = 0;
    /// slopes - slopes'; turn_lost where iterates turn farther than the final step, which alone is checked.
    virtual Status step_residual(const Real* slopes, Real* r) = 0;
    /// v~+ - v~, linear in the slopes.
    virtual void add_change(const Real* slopes, const Real& sign, VecX& to) const = 0;
    /// What a change of the slopes adds to the increment from q~ to q~+, over h.
    virtual void add_increment(const Real* slopes, const Real& sign, VecX& to) const = 0;
    /// Where slopes themselves follow v~: r of slopes for v~ - shift in place of v~.
    virtual void follow(const VecX& /*shift*/, Real* /*r*/) const {}
    const VecX& start_velocity() const { return v_; }  ///< v

    System& system_;
    const MotionScale& scale_;
    const Eigen::Index n_, m_;
    std::vector<Real> start_, middle_, free_;  // q~, the middle, q~+
    VecX moved_, u_;                           // n; moved_: v~
    Real t_ = 0, h_ = 0;

  private:
    /// shift_ = G(q) multipliers, G = M^{-1} C^T.
    void pull_back(const Real& t, const Real* q, const Real* multipliers);
    void place_end(const Real* mu);
    Status correct(const Real* x, Real* r);

    const Eigen::Index slopes_;
    std::vector<Real> configuration_;   // q+
    VecX v_, shift_, velocity_, zero_;  // n
    VecX rows_, phi_;                   // m
    Real end_ = 0;
    const Real* q_ = nullptr;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
