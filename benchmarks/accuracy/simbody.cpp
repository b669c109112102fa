// SPDX-License-Identifier: BSD-3-Clause
//
// Simbody [sherman2011]: a body on a ball joint, whose coordinates are a quaternion, by its best integrator for this:
// RungeKuttaFeldberg takes as long at 1e-9 m, lower orders longer, and CPodes fails an assertion of Debian's library,
// whose classes have the layout without NDEBUG.
#undef NDEBUG
#include <Simbody.h>

#include "benchmarks/accuracy/contender.hpp"

namespace accuracy {

namespace {

struct SimbodyTop {
    SimTK::MultibodySystem system;
    SimTK::SimbodyMatterSubsystem matter{system};
    SimTK::GeneralForceSubsystem forces{system};
    SimTK::Force::Gravity weight{forces, matter, SimTK::Vec3(0, 0, -gravity)};
    SimTK::MobilizedBody::Ball top;
    SimTK::State state;

    SimbodyTop() {
        const SimTK::Vec3 lever(0, 1, 0);
        const SimTK::MassProperties properties(mass, lever,
                                               SimTK::Inertia(inertia[0] + mass, inertia[1], inertia[2] + mass));
        top = SimTK::MobilizedBody::Ball(matter.Ground(), SimTK::Transform(), SimTK::Body::Rigid(properties),
                                         SimTK::Transform());
        state = system.realizeTopology();
        system.realizeModel(state);
        top.setUToFitAngularVelocity(state, SimTK::Vec3(spin[0], spin[1], spin[2]));  // R = I: body axes are space axes
    }
};

class SimbodyRun final : public Run {
  public:
    explicit SimbodyRun(double accuracy) {
        integrator_.setAccuracy(accuracy);
        integrator_.setFinalTime(t_end);
    }
    bool integrate() override {
        try {
            SimTK::TimeStepper stepper(top_.system, integrator_);
            stepper.initialize(top_.state);
            stepper.stepTo(t_end);
            top_.state = stepper.getState();
        } catch (const std::exception&) { return false; }
        return true;
    }
    std::array<double, 3> position() const override {
        top_.system.realize(top_.state, SimTK::Stage::Position);
        const SimTK::Vec3 x = top_.top.getBodyRotation(top_.state) * SimTK::Vec3(0, 1, 0);
        return {x[0], x[1], x[2]};
    }
    long evaluations() const override { return integrator_.getNumRealizations(); }

  private:
    SimbodyTop top_;
    SimTK::RungeKuttaMersonIntegrator integrator_{top_.system};
};

}  // namespace

std::vector<Contender> simbody_contenders() {
    return {{Contender::Kind::engine, "Simbody RungeKuttaMerson", false, ladder(1e-9, 0.1, 1e-14),
             [](double accuracy) { return std::make_unique<SimbodyRun>(accuracy); }}};
}

}  // namespace accuracy
