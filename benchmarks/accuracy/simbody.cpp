// SPDX-License-Identifier: BSD-3-Clause
//
// Simbody [sherman2011]: a body on a ball joint, whose coordinates are a quaternion, by its two integrators of highest
// order that run. (CPodes fails an assertion of Debian's library, whose classes have the layout without NDEBUG.)
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

using MakeIntegrator = std::function<std::unique_ptr<SimTK::Integrator>(const SimTK::System&)>;

class SimbodyRun final : public Run {
  public:
    SimbodyRun(const MakeIntegrator& make, double accuracy) : integrator_(make(top_.system)) {
        integrator_->setAccuracy(accuracy);
        integrator_->setFinalTime(t_end);
    }
    bool integrate() override {
        try {
            SimTK::TimeStepper stepper(top_.system, *integrator_);
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
    long evaluations() const override { return integrator_->getNumRealizations(); }

  private:
    SimbodyTop top_;
    std::unique_ptr<SimTK::Integrator> integrator_;
};

Contender simbody(const std::string& name, const MakeIntegrator& make) {
    return {Contender::Kind::engine, "Simbody " + name, false, ladder(1e-6, 0.1, 1e-14),
            [make](double accuracy) { return std::make_unique<SimbodyRun>(make, accuracy); }};
}

template <class Integrator>
std::unique_ptr<SimTK::Integrator> made(const SimTK::System& system) {
    return std::make_unique<Integrator>(system);
}

}  // namespace

std::vector<Contender> simbody_contenders() {
    return {simbody("RungeKuttaMerson", made<SimTK::RungeKuttaMersonIntegrator>),
            simbody("RungeKuttaFeldberg", made<SimTK::RungeKuttaFeldbergIntegrator>)};
}

}  // namespace accuracy
