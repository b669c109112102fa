// SPDX-License-Identifier: BSD-3-Clause
//
// IDA of SUNDIALS [hindmarsh2005], variable-order BDF, on the index-1 system of the constrained top: y = (x, q, v,
// omega, lambda), with the joint at r = -(0, 1, 0) from the mass centre and its force lambda on the body,
//   x' = v,  q' = 1/2 q (0, omega),  m (v' - g) = lambda,  J omega' + omega x J omega = r x R^T lambda,
//   v' + R (omega' x r + omega x (omega x r)) = 0.
#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <Eigen/Dense>
#include <algorithm>

#include "benchmarks/accuracy/contender.hpp"

namespace accuracy {

namespace {

using Vector = Eigen::Vector3d;
constexpr int size = 16;

Vector vector(const double* p) { return {p[0], p[1], p[2]}; }
void put(const Vector& v, double* p) { p[0] = v[0], p[1] = v[1], p[2] = v[2]; }

int ida_residual(realtype, N_Vector state, N_Vector rate, N_Vector residual, void* evaluations) {
    ++*static_cast<long*>(evaluations);
    const double *y = N_VGetArrayPointer(state), *dy = N_VGetArrayPointer(rate);
    double* F = N_VGetArrayPointer(residual);
    const Vector r(0, -1, 0), J(inertia[0], inertia[1], inertia[2]), v = vector(y + 7), w = vector(y + 10);
    const Vector lambda = vector(y + 13), dw = vector(dy + 10), half = w / 2;
    const Eigen::Quaterniond q(y[3], y[4], y[5], y[6]);
    const Eigen::Matrix3d R = q.toRotationMatrix();
    put(vector(dy) - v, F);
    F[3] = dy[3] + q.vec().dot(half);
    put(vector(dy + 4) - q.w() * half - q.vec().cross(half), F + 4);
    put(mass * (vector(dy + 7) - Vector(0, 0, -gravity)) - lambda, F + 7);
    put(J.cwiseProduct(dw) + w.cross(J.cwiseProduct(w)) - r.cross(R.transpose() * lambda), F + 10);
    put(vector(dy + 7) + R * (dw.cross(r) + w.cross(w.cross(r))), F + 13);
    return 0;
}

template <class T>
using Owned = std::unique_ptr<std::remove_pointer_t<T>, void (*)(T)>;

SUNContext made_context() {
    SUNContext context = nullptr;
    SUNContext_Create(nullptr, &context);
    return context;
}

class IdaRun final : public Run {
  public:
    explicit IdaRun(double tolerance) {
        start(N_VGetArrayPointer(y_.get()), N_VGetArrayPointer(dy_.get()));
        for (int i = 0; i < size; ++i) N_VGetArrayPointer(id_.get())[i] = i < 13 ? 1 : 0;
        IDAInit(ida_.get(), ida_residual, 0, y_.get(), dy_.get());
        IDASetUserData(ida_.get(), &evaluations_);
        IDASStolerances(ida_.get(), tolerance, tolerance);
        IDASetMaxNumSteps(ida_.get(), 1000000);
        IDASetErrFile(ida_.get(), nullptr);
        IDASetSuppressAlg(ida_.get(), SUNTRUE);  // lambda would keep steps some hundred times shorter
        IDASetId(ida_.get(), id_.get());
        IDASetLinearSolver(ida_.get(), solver_.get(), matrix_.get());
        IDASetStopTime(ida_.get(), t_end);
    }
    bool integrate() override {
        double t = 0;
        return IDASolve(ida_.get(), t_end, &t, y_.get(), dy_.get(), IDA_NORMAL) >= 0;
    }
    std::array<double, 3> position() const override {
        const double* y = N_VGetArrayPointer(y_.get());
        return {y[0], y[1], y[2]};
    }
    long evaluations() const override { return evaluations_; }

  private:
    /// Consistent to round-off: IDACalcIC does not reach the tightest tolerances. R = I.
    static void start(double* y, double* dy) {
        std::fill_n(y, size, 0), std::fill_n(dy, size, 0);
        const Vector x(0, 1, 0), w(spin[0], spin[1], spin[2]), g(0, 0, -gravity);
        const Vector J_O(inertia[0] + mass, inertia[1], inertia[2] + mass);
        const Vector dw = (x.cross(mass * g) - w.cross(J_O.cwiseProduct(w))).cwiseQuotient(J_O);
        const Vector dv = dw.cross(x) + w.cross(w.cross(x));
        put(x, y), y[3] = 1, put(w.cross(x), y + 7), put(w, y + 10), put(mass * (dv - g), y + 13);
        put(w.cross(x), dy), put(w / 2, dy + 4), put(dv, dy + 7), put(dw, dy + 10);
    }

    Owned<N_Vector> vector_of_size() { return {N_VNew_Serial(size, context_.get()), N_VDestroy}; }

    long evaluations_ = 0;
    Owned<SUNContext> context_{made_context(), [](SUNContext c) { SUNContext_Free(&c); }};
    Owned<N_Vector> y_ = vector_of_size(), dy_ = vector_of_size(), id_ = vector_of_size();
    Owned<SUNMatrix> matrix_{SUNDenseMatrix(size, size, context_.get()), SUNMatDestroy};
    Owned<SUNLinearSolver> solver_{SUNLinSol_Dense(y_.get(), matrix_.get(), context_.get()),
                                   [](SUNLinearSolver s) { SUNLinSolFree(s); }};
    std::unique_ptr<void, void (*)(void*)> ida_{IDACreate(context_.get()), [](void* memory) { IDAFree(&memory); }};
};

}  // namespace

std::vector<Contender> ida_contenders() {
    return {{Contender::Kind::engine, "SUNDIALS IDA", false, ladder(1e-10, 0.1, 1e-14),
             [](double tolerance) { return std::make_unique<IdaRun>(tolerance); }}};
}

}  // namespace accuracy
