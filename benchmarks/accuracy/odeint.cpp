// SPDX-License-Identifier: BSD-3-Clause
//
// Boost.Odeint [ahnert2011] on the hand-reduced top.
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include "benchmarks/accuracy/quaternion_top.hpp"

namespace accuracy {

namespace {

namespace odeint = boost::numeric::odeint;

class QuaternionRun : public Run {
  public:
    std::array<double, 3> position() const override { return quaternion_position(y_.data()); }
    long evaluations() const override { return evaluations_; }

  protected:
    auto equations() {
        return [this](const State& y, State& dy, double) {
            ++evaluations_;
            quaternion_top(y.data(), dy.data());
        };
    }
    State y_ = quaternion_start;

  private:
    long evaluations_ = 0;
};

template <class Stepper>
class OdeintSteps final : public QuaternionRun {
  public:
    explicit OdeintSteps(double steps) : steps_(static_cast<long>(steps)) {}
    bool integrate() override {
        const double h = t_end / static_cast<double>(steps_);
        const auto f = equations();
        for (long i = 0; i < steps_; ++i) stepper_.do_step(f, y_, h * static_cast<double>(i), h);
        return true;
    }

  private:
    long steps_;
    Stepper stepper_;
};

template <class Stepper>
class OdeintTolerance final : public QuaternionRun {
  public:
    explicit OdeintTolerance(Stepper stepper) : stepper_(std::move(stepper)) {}
    bool integrate() override {
        try {
            odeint::integrate_adaptive(std::ref(stepper_), equations(), y_, 0.0, t_end, t_end / 1000);
        } catch (const odeint::odeint_error&) { return false; }
        return true;
    }

  private:
    Stepper stepper_;
};

template <class Stepper>
std::unique_ptr<Run> to_tolerance(Stepper stepper) {
    return std::make_unique<OdeintTolerance<Stepper>>(std::move(stepper));
}

template <class Stepper>
void add_runge_kutta(const std::string& name, std::vector<Contender>& all) {
    all.push_back({Contender::Kind::rival, name, true, step_counts(128, 16384),
                   [](double n) { return std::make_unique<OdeintSteps<Stepper>>(n); }});
    all.push_back({Contender::Kind::rival, name, false, tolerances(1e-6, 1e-15),
                   [](double tol) { return to_tolerance(odeint::make_controlled<Stepper>(tol, tol)); }});
}

}  // namespace

std::vector<Contender> odeint_contenders() {
    std::vector<Contender> all;
    add_runge_kutta<odeint::runge_kutta_fehlberg78<State>>("Boost.Odeint runge_kutta_fehlberg78", all);
    add_runge_kutta<odeint::runge_kutta_dopri5<State>>("Boost.Odeint runge_kutta_dopri5", all);
    all.push_back({Contender::Kind::rival, "Boost.Odeint bulirsch_stoer", false, tolerances(1e-6, 1e-15),
                   [](double tol) { return to_tolerance(odeint::bulirsch_stoer<State>(tol, tol)); }});
    return all;
}

}  // namespace accuracy
