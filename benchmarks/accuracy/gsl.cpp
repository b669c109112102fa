// SPDX-License-Identifier: GPL-3.0-or-later
//
// GSL's rk8pd and msadams on the hand-reduced top. The library is Debian's, for generic x86-64: measured as users get
// it.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include "benchmarks/accuracy/quaternion_top.hpp"

namespace accuracy {

namespace {

int gsl_equations(double, const double* y, double* dy, void* evaluations) {
    ++*static_cast<long*>(evaluations);
    quaternion_top(y, dy);
    return GSL_SUCCESS;
}

class GslRun final : public Run {
  public:
    /// Steps where there are any, else a tolerance.
    GslRun(const gsl_odeiv2_step_type* type, double tolerance, long steps)
        : steps_(steps),
          system_{gsl_equations, nullptr, y_.size(), &evaluations_},
          driver_(gsl_odeiv2_driver_alloc_y_new(&system_, type, t_end / 1000, tolerance, tolerance),
                  gsl_odeiv2_driver_free) {
        gsl_odeiv2_driver_set_nmax(driver_.get(), 10000000);
    }
    bool integrate() override {
        double t = 0;
        if (steps_ == 0) return gsl_odeiv2_driver_apply(driver_.get(), &t, t_end, y_.data()) == GSL_SUCCESS;
        const double h = t_end / static_cast<double>(steps_);
        const auto n = static_cast<unsigned long>(steps_);
        return gsl_odeiv2_driver_apply_fixed_step(driver_.get(), &t, h, n, y_.data()) == GSL_SUCCESS;
    }
    std::array<double, 3> position() const override { return quaternion_position(y_.data()); }
    long evaluations() const override { return evaluations_; }

  private:
    long steps_, evaluations_ = 0;
    State y_ = quaternion_start;
    gsl_odeiv2_system system_;
    std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver_;
};

}  // namespace

std::vector<Contender> gsl_contenders() {
    gsl_set_error_handler_off();  // it would end the program
    // A driver of constant steps still judges them: by a tolerance that it always meets.
    return {{Contender::Kind::rival, "GSL rk8pd", true, step_counts(128, 16384),
             [](double n) { return std::make_unique<GslRun>(gsl_odeiv2_step_rk8pd, 1e300, static_cast<long>(n)); }},
            {Contender::Kind::rival, "GSL rk8pd", false, tolerances(1e-6, 1e-14),
             [](double tol) { return std::make_unique<GslRun>(gsl_odeiv2_step_rk8pd, tol, 0); }},
            {Contender::Kind::rival, "GSL msadams", false, tolerances(1e-6, 1e-14),
             [](double tol) { return std::make_unique<GslRun>(gsl_odeiv2_step_msadams, tol, 0); }}};
}

}  // namespace accuracy
