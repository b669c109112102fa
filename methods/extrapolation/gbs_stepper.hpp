// SPDX-License-Identifier: BSD-3-Clause
//
// Extrapolation that chooses order and step to a tolerance (methods/extrapolation/order_and_step.hpp).
#pragma once

#include <string>

#include "methods/control/error_norm.hpp"
#include "methods/control/fitted_step.hpp"
#include "methods/control/step_projection.hpp"
#include "methods/control/stepper.hpp"
#include "methods/extrapolation/base.hpp"
#include "methods/extrapolation/extrapolation.hpp"
#include "methods/extrapolation/neville.hpp"
#include "methods/extrapolation/order_and_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class GbsStepper final : public Stepper {
  public:
    GbsStepper(System& system, Projection& projection, const MakeExtrapolationBase& base, const Accuracy& accuracy,
               std::string name);

    Status start(const Real& t, const Real& t_end, const Real* y) override;
    Status step(Real& t, const Real& limit, Real* y) override;
    std::string failed_part() const override;
    const Work& work() const override { return work_; }

  private:
    /// An attempt at y -> new_; `line` is the one in which it ended, and `accepted` whether by convergence.
    Status attempt(const Real& t, const FittedStep& fitted, const Real* y, int& line, bool& accepted);
    Status lines(const Real& t, const FittedStep& fitted, const Real* y, int& line, bool& accepted);
    /// The error of T_jj and new_ = its state.
    Real error_of_line(const Real& H, const Real* y);

    System& system_;
    StepProjection projection_;
    Work work_;
    std::unique_ptr<ExtrapolationBase> base_;
    NevilleTable table_;
    OrderAndStep control_;
    ErrorNorm norm_;
    Real tolerance_;
    std::string name_;
    std::vector<Real> new_, slope_;
    bool first_known_ = false, in_projection_ = false;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
