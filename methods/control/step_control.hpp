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
#include "methods/control/stepper.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class StepControl final : public Stepper {
  public:
    /// `estimate` is r of the error estimate O(h^r), `name` that of the method for messages. System and projection
    /// outlive this; a null projection is none.
    StepControl(System& system, std::unique_ptr<Integrator> method, Projection* projection, const Accuracy& accuracy,
                int estimate, std::string name);

    Status start(const Real& t, const Real& t_end, const Real* y) override;
    Status step(Real& t, const Real& limit, Real* y) override;
    std::string failed_part() const override;
    const Work& work() const override { return method_->work(); }

  private:
    /// The step to take from t: the proposed one, or what is left to the limit, or half of that where the proposed one
    /// would leave a tiny rest.
    Real fitted(const Real& t, const Real& limit) const;
    /// One attempt at y -> new_; its error relative to the tolerance, or the status that it ended in.
    Status attempt(const Real& t, const Real& h, const Real& end, const Real* y, Real& error);
    /// The first step, from the slope at the start and one explicit Euler step [hairer1993, Sec. II.4].
    Status guess(const Real& t, const Real* y);

    System& system_;
    std::unique_ptr<Integrator> method_;
    Projection* projection_;
    ErrorNorm norm_;
    StepSizeController controller_;
    std::string name_, projected_;
    std::vector<Real> new_, unprojected_, error_, slope_;
    Real t_end_ = 0, h_ = 0;
    int estimate_;
    bool in_projection_ = false;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
