// SPDX-License-Identifier: BSD-3-Clause
//
// What chooses the steps of a run to a tolerance: as a rule StepControl around a method with an error estimate, else a
// control of the method's own (Factory::stepper).
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "lie/real.hpp"
#include "lie/status.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/contract/projection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// What steps are chosen by.
struct Accuracy {
    Real tolerance = 0;             ///< of the error of a step, each unknown over its scale
    Real length = 1;                ///< m, of the mechanism (mechanics/model/scales.hpp: extent); scale of positions
    std::string controller = "pi";  ///< elementary, pi or pid
};

class Stepper {
  public:
    virtual ~Stepper() = default;
    /// Called before the first step, and whenever y is not what the last step left. `t_end` bounds the steps to come,
    /// and fixes their direction.
    virtual Status start(const Real& t, const Real& t_end, const Real* y) = 0;
    /// One accepted step of y, with the projection in it, from t to a new t not beyond `limit`; if it gets there, t is
    /// `limit` exactly. Any status but ok leaves t and y as they were.
    virtual Status step(Real& t, const Real& limit, Real* y) = 0;
    /// Within the last step, from y0 by h, for methods with dense output of their own: y = y(t + theta h).
    virtual void interpolate(const Real& /*theta*/, const Real& /*h*/, const Real* /*y0*/, Real* /*y*/) {
        throw std::logic_error("dense output of a control that has none of its own");
    }
    /// After a status that is not ok, the part that gave it: "step of rkmk/dopri5", "projection velocity".
    virtual std::string failed_part() const = 0;
    virtual const Work& work() const = 0;
    /// The multipliers of a control of the method's own at the end of the last step, as Integrator::multipliers.
    virtual const Real* multipliers() const { return nullptr; }

    long accepted() const { return accepted_; }  ///< steps since construction
    long rejected() const { return rejected_; }  ///< attempts since construction

  protected:
    long accepted_ = 0, rejected_ = 0;
};

/// The method with its steps chosen to a tolerance: by its own control, or by StepControl. System and projection
/// outlive the stepper. Throws std::logic_error for a method that has neither a control nor an error estimate.
std::unique_ptr<Stepper> bind_stepper(const Method& method, System& system, Projection& projection,
                                      const Accuracy& accuracy, const OptionValues& options);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
