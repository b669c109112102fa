// SPDX-License-Identifier: BSD-3-Clause
//
// Baseline: IDA of SUNDIALS [hindmarsh2005] on quaternions, BDF of orders 1 to 5 for the index-1 form with the
// multipliers among the unknowns, with its control of order and step: what one gives to a solver of
// differential-algebraic equations. Newton's method has a dense Jacobian by differences; multipliers take no part in
// the error test.
#include "peers/double_only.hpp"
#if !KREISEL_QUAD
#include <ida/ida.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>

#include "peers/stepper.hpp"
#include "peers/sundials/index1_residual.hpp"
#include "peers/sundials/owned.hpp"
#endif

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

#if KREISEL_QUAD

Factory sundials_ida() { return double_only("baseline/sundials_ida"); }

#else

class IdaStepper final : public PeerStepper {
  public:
    IdaStepper(System& system, Projection& projection, const Accuracy& accuracy, const MethodDescription& description)
        : PeerStepper(system, projection, accuracy, description, 2),
          residual_(system, equations_),
          x_(residual_.size()),
          dx_(x_),
          differential_(x_),
          lambda_(static_cast<std::size_t>(system.constraints())),
          context_(sundials_context()) {
        std::fill_n(differential_.begin(), residual_.unknowns(), Real(1));
    }

    const Real* multipliers() const override { return known_ && !lambda_.empty() ? lambda_.data() : nullptr; }

  protected:
    Status begin(const Real& t) override {
        known_ = false;
        const Status status = residual_.start(t, unknowns_.data(), x_.data(), dx_.data());
        if (status != Status::ok) return status;
        x_vector_ = of(x_), dx_vector_ = of(dx_), id_ = of(differential_);
        ida_ = {IDACreate(context_.get()), [](void* memory) { IDAFree(&memory); }};
        IDASetErrHandlerFn(ida_.get(), say_nothing, nullptr);
        IDASetUserData(ida_.get(), this);
        IDAInit(ida_.get(), residual, t, x_vector_.get(), dx_vector_.get());
        IDASStolerances(ida_.get(), 0, tolerance_);
        IDASetId(ida_.get(), id_.get());
        IDASetSuppressAlg(ida_.get(), SUNTRUE);
        const auto n = static_cast<sunindextype>(x_.size());
        matrix_ = {SUNDenseMatrix(n, n, context_.get()), SUNMatDestroy};
        linear_ = {SUNLinSol_Dense(x_vector_.get(), matrix_.get(), context_.get()),
                   [](SUNLinearSolver s) { SUNLinSolFree(s); }};
        IDASetLinearSolver(ida_.get(), linear_.get(), matrix_.get());
        failed_ = iterations_ = 0;
        return Status::ok;
    }

    Status advance(Real& t, const Real& limit) override {
        Real reached = t;
        IDASetStopTime(ida_.get(), limit);
        const int result = IDASolve(ida_.get(), limit, &reached, x_vector_.get(), dx_vector_.get(), IDA_ONE_STEP);
        count();
        if (result == IDA_LSETUP_FAIL) return equations_.status(Status::singular_kkt);
        if (result < 0)
            return equations_.status(result == IDA_CONV_FAIL ? Status::newton_failed : Status::step_too_small);
        if (reached == t) return Status::step_too_small;
        std::copy_n(x_.begin(), unknowns_.size(), unknowns_.begin());
        residual_.multipliers(x_.data(), lambda_.data());
        known_ = true;
        t = result == IDA_TSTOP_RETURN ? limit : reached;
        return Status::ok;
    }

  private:
    static int residual(realtype t, N_Vector x, N_Vector dx, N_Vector F, void* self) {
        auto& stepper = *static_cast<IdaStepper*>(self);
        const bool finite =
            stepper.residual_.evaluate(t, N_VGetArrayPointer(x), N_VGetArrayPointer(dx), N_VGetArrayPointer(F));
        if (!finite) stepper.equations_.fail(Status::non_finite);
        return finite ? 0 : 1;  // 1: a shorter step may do
    }

    Owned<N_Vector> of(std::vector<Real>& x) const { return vector_of(x.data(), x.size(), context_.get()); }

    void count() {
        long by_error = 0, by_iteration = 0, iterations = 0;
        IDAGetNumErrTestFails(ida_.get(), &by_error);
        IDAGetNumStepSolveFails(ida_.get(), &by_iteration);
        IDAGetNumNonlinSolvIters(ida_.get(), &iterations);
        rejected_ += by_error + by_iteration - failed_;
        failed_ = by_error + by_iteration;
        work_.newton_iterations += iterations - iterations_;
        iterations_ = iterations;
    }

    Index1Residual residual_;
    std::vector<Real> x_, dx_, differential_, lambda_;
    bool known_ = false;                // lambda_
    long failed_ = 0, iterations_ = 0;  // since `begin`
    Owned<SUNContext> context_;         // before what lives in it
    Owned<N_Vector> x_vector_, dx_vector_, id_;
    Owned<SUNMatrix> matrix_;
    Owned<SUNLinearSolver> linear_;
    Owned<void*> ida_;
};

Factory sundials_ida() {
    Factory factory;
    factory.stepper = [](System& system, Projection& projection, const Accuracy& accuracy, const OptionValues&,
                         const MethodDescription& description) {
        return std::make_unique<IdaStepper>(system, projection, accuracy, description);
    };
    return factory;
}

#endif

}  // namespace

KREISEL_METHOD(
    sundials_ida(),
    {.name = "baseline/sundials_ida",
     .order = 5,
     .cites = {"hindmarsh2005"},
     .summary = "IDA of SUNDIALS on quaternions: BDF with multipliers as unknowns, with its control of order "
                "and step",
     .own_control = true,
     .projectable = false,
     .form = Form::implicit,
     .reports_multipliers = true,
     .formulations = {"SO3", "SO3xR3"}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
