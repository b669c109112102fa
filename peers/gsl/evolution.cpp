// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers/gsl/evolution.hpp"

#include <gsl/gsl_errno.h>

#include <memory>
#include <new>

#include "peers/stepper.hpp"

#if !KREISEL_QUAD

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class GslStepper final : public PeerStepper {
  public:
    GslStepper(System& system, Projection& projection, const Accuracy& accuracy, const MethodDescription& description,
               const gsl_odeiv2_step_type* type, int first_order)
        : PeerStepper(system, projection, accuracy, description, first_order),
          equations_of_gsl_{derivative, nullptr, unknowns_.size(), this},
          driver_(make_driver(type), gsl_odeiv2_driver_free) {
        if (!driver_) throw std::bad_alloc();
    }

  protected:
    Status begin(const Real&) override {
        gsl_odeiv2_evolve_reset(driver_->e);
        gsl_odeiv2_step_reset(driver_->s);
        return Status::ok;
    }

    /// gsl_odeiv2_evolve_apply repeats an attempt until it is accepted.
    Status advance(Real& t, const Real& limit) override {
        const unsigned long failed = driver_->e->failed_steps;
        Real reached = t;
        const int result = gsl_odeiv2_evolve_apply(driver_->e, driver_->c, driver_->s, &equations_of_gsl_, &reached,
                                                   limit, &h_, unknowns_.data());
        rejected_ += static_cast<long>(driver_->e->failed_steps - failed);
        // What fails in an attempt that was repeated does not matter; GSL does not repeat one for NaN.
        if (result != GSL_SUCCESS || last_failed_) return equations_.status(Status::step_too_small);
        if (lost()) return Status::step_too_small;
        t = reached;
        return Status::ok;
    }

  private:
    /// A status of the equations of motion is GSL_FAILURE, upon which GSL halves the step.
    static int derivative(double t, const double* u, double* du, void* self) {
        auto& stepper = *static_cast<GslStepper*>(self);
        stepper.last_failed_ = !stepper.equations_.derivative(t, u, du);
        return stepper.last_failed_ ? GSL_FAILURE : GSL_SUCCESS;
    }

    gsl_odeiv2_driver* make_driver(const gsl_odeiv2_step_type* type) {
        [[maybe_unused]] static gsl_error_handler_t* const aborting = gsl_set_error_handler_off();
        // The driver belongs to the multistep methods, which ask its control for the tolerance; its first step is not
        // used.
        return gsl_odeiv2_driver_alloc_y_new(&equations_of_gsl_, type, 1, tolerance_, 0);
    }

    gsl_odeiv2_system equations_of_gsl_;
    std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver_;
    bool last_failed_ = false;
};

}  // namespace

Factory gsl_evolution(const gsl_odeiv2_step_type* type, int stages, int first_order) {
    Factory factory;
    factory.stages = stages;
    factory.stepper = [type, first_order](System& system, Projection& projection, const Accuracy& accuracy,
                                          const OptionValues&, const MethodDescription& description) {
        return std::make_unique<GslStepper>(system, projection, accuracy, description, type, first_order);
    };
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel

#endif
