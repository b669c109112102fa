// SPDX-License-Identifier: BSD-3-Clause
//
// The front door in C++: a model, the formulation of its state space, a method and a projection, and the state they
// move.
//
//   Simulation top(model, {.formulation = "SO3xR3", .method = "rkmk/rk4", .projection = "position_velocity"});
//   if (top.advance(1, 1000) != Status::ok) std::cerr << top.failure();
//   std::cout << top.bodies()[0].x;
//
// With a tolerance the method chooses its steps: {.method = "rkmk/dopri5", .tolerance = 1e-8}, and top.advance(1).
#pragma once

#include <concepts>
#include <memory>
#include <string>
#include <vector>

#include "mechanics/formulation.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/contract/projection.hpp"
#include "methods/control/stepper.hpp"
#include "methods/passage.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// What moves a model; options not given have their defaults.
struct Setup {
    std::string formulation = "SO3xR3", method = "rkmk/rk4";
    OptionValues options = {};
    std::string projection = "none";
    OptionValues projection_options = {};
    Real tolerance = 0;             ///< 0: steps of a given size; else see methods/control/stepper.hpp
    std::string controller = "pi";  ///< of steps to a tolerance: elementary, pi, pid
};

/// The same from parts that need not be registered, such as doubles of tests; integrator and projection are those of
/// this system. Steps have a given size, and poses in which constraints lose rank are not looked out for.
struct SimulationParts {
    std::unique_ptr<System> system;
    std::unique_ptr<Integrator> integrator;
    std::unique_ptr<Projection> projection;
    std::string method = "the method", projector = "of the parts";  ///< names, for messages
    std::unique_ptr<System> changed = {};                           ///< that of the integrator, where it is another one
};

class Simulation {
  public:
    /// At the start of the model, t = 0. Throws std::out_of_range for names that are not registered and OptionError for
    /// options that a method does not take; Formulation::why_not tells whether the formulation applies.
    Simulation(Model model, const Setup& setup);
    Simulation(SimulationParts parts, Model model);
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    const Model& model() const { return model_; }
    /// Of the equations of motion as they are, also where a stabilisation changes those that are integrated.
    System& system() { return *system_; }
    const System& system() const { return *system_; }
    const Projection& projection() const { return *projection_; }

    const Real& time() const { return t_; }                  ///< s
    const std::vector<Real>& state() const { return y_; }    ///< y = (q, v) in TG
    const Real* q() const { return y_.data(); }              ///< configuration
    const Real* v() const { return system_->v(y_.data()); }  ///< velocities, in the coordinates of the formulation
    std::vector<BodyState> bodies() const;
    /// The method's own multipliers after the last step, or null (Integrator::multipliers).
    const Real* multipliers() const { return stepper_ ? stepper_->multipliers() : integrator_->multipliers(); }
    /// Null where steps have a given size.
    const Stepper* stepper() const { return stepper_.get(); }
    const Work& work() const { return stepper_ ? stepper_->work() : integrator_->work(); }

    /// Sets time and state; `restart` or `advance` goes on from there.
    void move_to(const Real& t, const std::vector<Real>& y) { t_ = t, y_ = y; }
    /// From the state y at time t on: what the method remembers of earlier steps is dropped. Needed before the first
    /// step of a user's own loop; `advance` does it by itself.
    Status restart(const Real& t, const std::vector<Real>& y);
    Status restart();
    /// The same before steps to a tolerance, which lead to t_end.
    Status restart_to(const Real& t_end);

    /// One step by h (s), then the projection; the time is t + h, or `end` if given, which avoids accumulated
    /// round-off. On any status but ok the time stays, and `failure` names the part that gave it.
    Status step(const Real& h) { return step(h, t_ + h); }
    Status step(const Real& h, const Real& end) {
        if (const Status status = integrator_->step(t_, h, y_.data()); status != Status::ok)
            return fail_in_step(status);
        if (const Status status = projection_->project(end, y_.data()); status != Status::ok) return fail_after(status);
        t_ = end;
        return Status::ok;
    }

    /// One step that the method chooses, not beyond `limit`; t is `limit` where it gets there.
    Status stride(const Real& limit) {
        const Status status = stepper_->step(t_, limit, y_.data());
        return status == Status::ok ? status : fail_in_stride(status);
    }

    /// Within the last of them, from y0 by h, if the method declares dense output of its own: y = y(t + theta h).
    void interpolate(const Real& theta, const Real& h, const Real* y0, Real* y) const {
        stepper_->interpolate(theta, h, y0, y);
    }

    /// To t_end (s) in steps that the method chooses; `observe(simulation)` is called after each of them.
    template <std::invocable<const Simulation&> Observer>
    Status advance(const Real& t_end, Observer observe) {
        if (const Status status = restart_to(t_end); status != Status::ok) return status;
        while (t_ != t_end) {
            if (const Status status = stride(t_end); status != Status::ok) return status;
            observe(*this);
        }
        return Status::ok;
    }
    Status advance(const Real& t_end) {
        return advance(t_end, [](const Simulation&) {});
    }

    /// `steps` steps from the time of the simulation to t_end (s), at the times t + i h. `observe(simulation)` is
    /// called after each of them.
    template <class Observer>
    Status advance(const Real& t_end, long steps, Observer observe) {
        const Real begin = t_, h = (t_end - begin) / Real(steps);
        if (const Status status = restart(); status != Status::ok) return status;
        for (long i = 1; i <= steps; ++i) {
            if (const Status status = step(h, i == steps ? t_end : Real(begin + h * Real(i))); status != Status::ok)
                return status;
            observe(*this);
        }
        return Status::ok;
    }
    Status advance(const Real& t_end, long steps) {
        return advance(t_end, steps, [](const Simulation&) {});
    }

    /// What the last status that is not ok came from, "step of rkmk/rk4"; and with the status and the system's
    /// explanation of it, "step of rkmk/rk4: left_chart".
    const std::string& failed_part() const { return failed_part_; }
    const std::string& failure_reason() const { return failure_reason_; }  ///< empty where nothing more is known
    const std::string& failure() const { return failure_; }

  private:
    Status fail(Status status, const std::string& part, const std::string& reason);
    // Texts stay out of `step`, which is inlined into loops.
    [[gnu::cold]] Status fail_in_step(Status status);
    /// After a step that has succeeded.
    [[gnu::cold]] Status fail_after(Status status);
    [[gnu::cold]] Status fail_in_stride(Status status);

    Setup setup_;
    Model model_;
    std::unique_ptr<System> system_;
    std::unique_ptr<System> changed_;  // what the method integrates, under a stabilisation
    std::unique_ptr<Integrator> integrator_;
    std::unique_ptr<Projection> projection_;
    std::unique_ptr<Stepper> stepper_;    // where there is a tolerance, and then there is no integrator
    SingularPassage* passage_ = nullptr;  // the projection, where the model has closed loops
    Real t_ = 0;
    std::vector<Real> y_;
    std::string failed_part_, failure_reason_, failure_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
