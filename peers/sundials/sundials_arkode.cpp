// SPDX-License-Identifier: BSD-3-Clause
//
// Baseline: explicit Runge-Kutta pairs of ARKODE, part of SUNDIALS [hindmarsh2005], on quaternions, with its step
// control; option `pair`. The result of the higher order is advanced. (Errors of its pair VERNER_8_5_6 are far above
// the tolerance in release 6.4.)
#include "peers/double_only.hpp"
#if !KREISEL_QUAD
#include <arkode/arkode_erkstep.h>

#include <algorithm>

#include "peers/stepper.hpp"
#include "peers/sundials/owned.hpp"
#endif

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const std::vector<OptionDescription> arkode_options = {{.name = "pair",
                                                        .summary = "of orders 5(4) and 8(7)",
                                                        .standard = "fehlberg",
                                                        .choices = {"dormand_prince", "fehlberg"}}};

#if KREISEL_QUAD

Factory sundials_arkode() {
    Factory factory = double_only("baseline/sundials_arkode");
    factory.options = arkode_options;
    return factory;
}

#else

struct ArkodePair {
    ARKODE_ERKTableID table;
    int order;
};

ArkodePair arkode_pair(const OptionValues& values) {
    const std::string name = std::get<std::string>(values.at("pair"));
    if (name == "dormand_prince") return {ARKODE_DORMAND_PRINCE_7_4_5, 5};
    return {ARKODE_FEHLBERG_13_7_8, 8};
}

class ArkodeStepper final : public PeerStepper {
  public:
    ArkodeStepper(System& system, Projection& projection, const Accuracy& accuracy,
                  const MethodDescription& description, const ArkodePair& pair)
        : PeerStepper(system, projection, accuracy, description, pair.order),
          table_(pair.table),
          context_(sundials_context()) {}

  protected:
    Status begin(const Real& t) override {
        u_ = vector_of(unknowns_.data(), unknowns_.size(), context_.get());
        arkode_ = {ERKStepCreate(derivative, t, u_.get(), context_.get()), [](void* memory) { ERKStepFree(&memory); }};
        ERKStepSetErrHandlerFn(arkode_.get(), say_nothing, nullptr);
        ERKStepSetUserData(arkode_.get(), this);
        ERKStepSetTableNum(arkode_.get(), table_);
        ERKStepSStolerances(arkode_.get(), 0, tolerance_);
        failed_ = 0;
        return Status::ok;
    }
    /// Keeps the step size.
    Status resume(const Real& t) override {
        return ERKStepReset(arkode_.get(), t, u_.get()) == ARK_SUCCESS ? Status::ok : Status::step_too_small;
    }

    Status advance(Real& t, const Real& limit) override {
        Real reached = t;
        ERKStepSetStopTime(arkode_.get(), limit);
        const int result = ERKStepEvolve(arkode_.get(), limit, u_.get(), &reached, ARK_ONE_STEP);
        count();
        if (result < 0 || reached == t) return equations_.status(Status::step_too_small);
        t = result == ARK_TSTOP_RETURN ? limit : reached;
        return Status::ok;
    }

  private:
    static int derivative(realtype t, N_Vector u, N_Vector du, void* self) {
        auto& stepper = *static_cast<ArkodeStepper*>(self);
        const bool found = stepper.equations_.derivative(t, N_VGetArrayPointer(u), N_VGetArrayPointer(du));
        return found ? 0 : 1;  // 1: a shorter step may do
    }

    void count() {
        long failed = 0, attempts = 0, steps = 0;
        ERKStepGetNumErrTestFails(arkode_.get(), &failed);
        ERKStepGetNumStepAttempts(arkode_.get(), &attempts);
        ERKStepGetNumSteps(arkode_.get(), &steps);
        failed = std::max(failed, attempts - steps);
        rejected_ += failed - failed_;
        failed_ = failed;
    }

    ARKODE_ERKTableID table_;
    long failed_ = 0;            // since `begin`
    Owned<SUNContext> context_;  // before what lives in it
    Owned<N_Vector> u_;
    Owned<void*> arkode_;
};

Factory sundials_arkode() {
    Factory factory;
    factory.options = arkode_options;
    factory.stages = 13;  // of the pair taken by default
    factory.order = [](const OptionValues& values, const Order&) { return Order(arkode_pair(values).order); };
    factory.stepper = [](System& system, Projection& projection, const Accuracy& accuracy, const OptionValues& values,
                         const MethodDescription& description) {
        return std::make_unique<ArkodeStepper>(system, projection, accuracy, description, arkode_pair(values));
    };
    return factory;
}

#endif

}  // namespace

KREISEL_METHOD(sundials_arkode(),
               {.name = "baseline/sundials_arkode",
                .order = 8,
                .cites = {"hindmarsh2005"},
                .summary = "explicit Runge-Kutta pairs of ARKODE (SUNDIALS) on quaternions, with its step control",
                .own_control = true,
                .formulations = {"SO3", "SO3xR3"}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
