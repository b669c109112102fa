// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lie/real.hpp"
#include "lie/status.hpp"
#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Moves a state y in TG by one step. Work space is sized when method and system meet: a step allocates nothing.
class Integrator {
  public:
    virtual ~Integrator() = default;
    /// Called before the first step, and whenever y is not what the last step left: methods with memory drop it here.
    virtual Status start(const Real& /*t*/, const Real* /*y*/) { return Status::ok; }
    /// y(t) -> y(t + h) in place. Any status but ok leaves y as it was.
    virtual Status step(const Real& t, const Real& h, Real* y) = 0;
    /// The method's own multipliers at the end of the last step, as forces (N) in the order of the rows of C. Null
    /// before the first step, without constraints, and for methods without: theirs follow from the index-1 form.
    virtual const Real* multipliers() const { return nullptr; }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
