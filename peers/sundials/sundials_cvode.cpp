// SPDX-License-Identifier: BSD-3-Clause
//
// Baseline: CVODE of SUNDIALS [hindmarsh2005] on quaternions, with its control of order and step: option `formula` is
// `adams` (orders 1 to 12, functional iteration) or `bdf` (orders 1 to 5, Newton's method with a dense Jacobian by
// differences).
#include "peers/double_only.hpp"
#if !KREISEL_QUAD
#include <cvode/cvode.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "peers/stepper.hpp"
#include "peers/sundials/owned.hpp"
#endif

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const std::vector<OptionDescription> cvode_options = {
    {.name = "formula", .summary = "adams: not stiff; bdf: stiff", .standard = "adams", .choices = {"adams", "bdf"}}};

#if KREISEL_QUAD

Factory sundials_cvode() {
    Factory factory = double_only("baseline/sundials_cvode");
    factory.options = cvode_options;
    return factory;
}

#else

class CvodeStepper final : public PeerStepper {
  public:
    CvodeStepper(System& system, Projection& projection, const Accuracy& accuracy, const MethodDescription& description,
                 bool stiff)
        : PeerStepper(system, projection, accuracy, description, 2), stiff_(stiff), context_(sundials_context()) {}

  protected:
    Status begin(const Real& t) override {
        u_ = vector_of(unknowns_.data(), unknowns_.size(), context_.get());
        cvode_ = {CVodeCreate(stiff_ ? CV_BDF : CV_ADAMS, context_.get()), [](void* memory) { CVodeFree(&memory); }};
        CVodeSetErrHandlerFn(cvode_.get(), say_nothing, nullptr);
        CVodeSetUserData(cvode_.get(), this);
        CVodeInit(cvode_.get(), derivative, t, u_.get());
        CVodeSStolerances(cvode_.get(), 0, tolerance_);
        CVodeSetMaxHnilWarns(cvode_.get(), -1);
        stiff_ ? solve_by_newton() : iterate();
        failed_ = 0;
        return Status::ok;
    }

    Status advance(Real& t, const Real& limit) override {
        Real reached = t;
        CVodeSetStopTime(cvode_.get(), limit);
        const int result = CVode(cvode_.get(), limit, u_.get(), &reached, CV_ONE_STEP);
        count();
        if (result < 0)
            return equations_.status(result == CV_CONV_FAILURE ? Status::newton_failed : Status::step_too_small);
        if (reached == t) return Status::step_too_small;
        t = result == CV_TSTOP_RETURN ? limit : reached;
        return Status::ok;
    }

  private:
    static int derivative(realtype t, N_Vector u, N_Vector du, void* self) {
        auto& stepper = *static_cast<CvodeStepper*>(self);
        const bool found = stepper.equations_.derivative(t, N_VGetArrayPointer(u), N_VGetArrayPointer(du));
        return found ? 0 : 1;  // 1: a shorter step may do
    }

    void iterate() {
        iteration_ = {SUNNonlinSol_FixedPoint(u_.get(), 0, context_.get()),
                      [](SUNNonlinearSolver s) { SUNNonlinSolFree(s); }};
        CVodeSetNonlinearSolver(cvode_.get(), iteration_.get());
    }

    void solve_by_newton() {
        const auto n = static_cast<sunindextype>(unknowns_.size());
        matrix_ = {SUNDenseMatrix(n, n, context_.get()), SUNMatDestroy};
        linear_ = {SUNLinSol_Dense(u_.get(), matrix_.get(), context_.get()),
                   [](SUNLinearSolver s) { SUNLinSolFree(s); }};
        CVodeSetLinearSolver(cvode_.get(), linear_.get(), matrix_.get());
    }

    void count() {
        long by_error = 0, by_iteration = 0, iterations = 0;
        CVodeGetNumErrTestFails(cvode_.get(), &by_error);
        CVodeGetNumStepSolveFails(cvode_.get(), &by_iteration);
        CVodeGetNumNonlinSolvIters(cvode_.get(), &iterations);
        rejected_ += by_error + by_iteration - failed_;
        failed_ = by_error + by_iteration;
        if (stiff_) work_.newton_iterations += iterations - iterations_;
        iterations_ = iterations;
    }

    bool stiff_;
    long failed_ = 0, iterations_ = 0;  // since `begin`
    Owned<SUNContext> context_;         // before what lives in it
    Owned<N_Vector> u_;
    Owned<SUNMatrix> matrix_;
    Owned<SUNLinearSolver> linear_;
    Owned<SUNNonlinearSolver> iteration_;
    Owned<void*> cvode_;
};

Factory sundials_cvode() {
    Factory factory;
    factory.options = cvode_options;
    factory.order = [](const OptionValues& values, const Order& declared) {
        return std::get<std::string>(values.at("formula")) == "bdf" ? Order(5) : declared;
    };
    factory.stepper = [](System& system, Projection& projection, const Accuracy& accuracy, const OptionValues& values,
                         const MethodDescription& description) {
        const bool stiff = std::get<std::string>(values.at("formula")) == "bdf";
        return std::make_unique<CvodeStepper>(system, projection, accuracy, description, stiff);
    };
    return factory;
}

#endif

}  // namespace

KREISEL_METHOD(sundials_cvode(),
               {.name = "baseline/sundials_cvode",
                .order = 12,
                .cites = {"hindmarsh2005"},
                .summary = "CVODE of SUNDIALS on quaternions: Adams methods or BDF, with its control of order and step",
                .own_control = true,
                .projectable = false,
                .formulations = {"SO3", "SO3xR3"}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
