// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>

#include "lie/real.hpp"
#include "lie/status.hpp"
#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// What steps have cost besides solves of the dynamics, which the system counts, since construction.
struct Work {
    long exponentials = 0;       ///< of the group, or other maps of local coordinates
    long brackets = 0;           ///< of the algebra; closed forms take none
    long newton_iterations = 0;  ///< of implicit steps
};

/// Moves a state y in TG by one step. Work space is sized when method and system meet: a step allocates nothing.
class Integrator {
  public:
    virtual ~Integrator() = default;
    /// Called before the first step, and whenever y is not what the last step left: methods with memory drop it here.
    virtual Status start(const Real& /*t*/, const Real* /*y*/) { return Status::ok; }
    /// y(t) -> y(t + h) in place. Any status but ok leaves y as it was.
    virtual Status step(const Real& t, const Real& h, Real* y) = 0;

    /// A step that may be rejected, of methods that declare an estimate (MethodDescription::estimate): y(t) ->
    /// y_new = y(t + h), elsewhere in storage, and `error`, the estimate of the local error in the algebra of TG
    /// (dim TG reals: (dq, dv)). Leaves nothing behind that a later attempt or step could see, until it is accepted.
    virtual Status attempt(const Real& /*t*/, const Real& /*h*/, const Real* /*y*/, Real* /*y_new*/, Real* /*error*/) {
        throw std::logic_error("attempt at a step by a method without an estimate of its error");
    }
    /// The last attempt is the step, which commits what it has learnt. `moved`: its y_new has been changed since, by a
    /// projection, so that slopes computed there are not those of the state.
    virtual void accept(bool /*moved*/) {}

    /// Of methods that declare dense output of their own (MethodDescription::dense): y = y(t + theta h), 0 <= theta <=
    /// 1, within the last attempt, which has been accepted; from y0 = y(t) and what the method remembers of its stages.
    virtual void interpolate(const Real& /*theta*/, const Real& /*h*/, const Real* /*y0*/, Real* /*y*/) {
        throw std::logic_error("dense output of a method that has none of its own");
    }

    /// The method's own multipliers at the end of the last step, as forces (N) in the order of the rows of C. Null
    /// before the first step, without constraints, and for methods without: theirs follow from the index-1 form.
    virtual const Real* multipliers() const { return nullptr; }
    virtual const Work& work() const { return work_; }

  protected:
    Work work_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
