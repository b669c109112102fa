// SPDX-License-Identifier: BSD-3-Clause
//
// Steps of a method with an error estimate, chosen to a tolerance: error per step, local extrapolation where the method
// has it. An attempt is rejected if its error is too large, if it ends in a status, or if its projection does; the
// projection acts before acceptance, and what it moves the state by counts as error.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mechanics/system.hpp"
#include "methods/control/controller.hpp"
#include "methods/control/error_norm.hpp"
#include "methods/control/fitted_step.hpp"
#include "methods/control/step_projection.hpp"
#include "methods/control/stepper.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class StepControl final : public Stepper {
  public:
    /// `description` is that of the method, which declares an estimate. System and projection outlive this.
    StepControl(System& system, Projection& projection, std::unique_ptr<Integrator> method, const Accuracy& accuracy,
                const MethodDescription& description);

    Status start(const Real& t, const Real& t_end, const Real* y) override;
    Status step(Real& t, const Real& limit, Real* y) override;
    void interpolate(const Real& theta, const Real& h, const Real* y0, Real* y) override {
        method_->interpolate(theta, h, y0, y);
    }
    std::string failed_part() const override;
    const Work& work() const override { return method_->work(); }
    const Real* multipliers() const override { return method_->multipliers(); }

  private:
    /// One attempt at y -> new_, with the projection. `error` is relative to the tolerance.
    Status attempt(const Real& t, const Real& h, const Real& end, const Real* y, Real& error);
    void accept(const FittedStep& fitted, const Real& error, Real* y);

    System& system_;
    std::unique_ptr<Integrator> method_;
    StepProjection projection_;
    ErrorNorm norm_;
    StepSizeController controller_;
    Real tolerance_;
    int estimate_;
    std::string name_;
    std::vector<Real> new_, error_;
    Real h_ = 0;                  // the size proposed for the next step; 0: none yet
    bool in_projection_ = false;  // where the last status comes from
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
