// SPDX-License-Identifier: BSD-3-Clause
//
// Steps of an integrator of another library, chosen by its own control: what all of them share. The state lives in the
// library's unknowns from step to step; y is written after each. A projection acts on an accepted step and is not part
// of its error; where it moves the state, the library starts again from there.
#pragma once

#include <string>
#include <vector>

#include "methods/contract/projection.hpp"
#include "methods/control/stepper.hpp"
#include "peers/equations.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class PeerStepper : public Stepper {
  public:
    Status start(const Real& t, const Real& t_end, const Real* y) final;
    Status step(Real& t, const Real& limit, Real* y) final;
    std::string failed_part() const final;
    const Work& work() const final { return work_; }

  protected:
    /// `first_order`: the order of the first step.
    PeerStepper(System& system, Projection& projection, const Accuracy& accuracy, const MethodDescription& description,
                int first_order);

    /// Drops all that is remembered: the run begins with the unknowns at t, and h is a first proposal.
    virtual Status begin(const Real& t) = 0;
    /// Goes on from unknowns that have been moved, with the step size proposed before.
    virtual Status resume(const Real& t) { return begin(t); }
    /// One accepted step of the unknowns, from t to a new t not beyond `limit`; counts attempts that were rejected. If
    /// it gets there, t is `limit` exactly.
    virtual Status advance(Real& t, const Real& limit) = 0;

    /// The proposed step is lost in the round-off of the run's time: the tolerance is out of reach. (At t = 0 no step
    /// is too small to move time.)
    bool lost() const { return abs(h_) < least_; }

    PeerEquations equations_;
    std::vector<Real> unknowns_;
    const Real tolerance_;
    Real h_ = 0;  // proposed for the next step, in its direction
    Work work_;

  private:
    Status begin_run(const Real& t, const Real& t_end, const Real* y);
    Status move(Real& t, const Real& limit);
    Status project(const Real& t);

    System& system_;
    Projection& projection_;
    std::string name_;
    Real first_;  // size of the first step times the rate of the motion
    Real t_end_ = 0, least_ = 0;
    std::vector<Real> new_, unprojected_;
    bool stale_ = false;  // the last step has failed, and the unknowns are no longer those of the state
    bool in_projection_ = false;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
