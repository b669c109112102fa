// SPDX-License-Identifier: BSD-3-Clause
//
// An independent reference: IDA of SUNDIALS [hindmarsh2005], variable-order BDF in double, on the index-1
// differential-algebraic equations of a model in rotation matrices, coded independently here.
#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <catch2/catch.hpp>

#include <memory>
#include <vector>

#include "engine/reference/taylor/taylor_route.hpp"
#include "engine/report/report.hpp"
#include "mechanics/start.hpp"
#include "tests/engine/named_problem.hpp"
#include "tests/mechanics/models/jointed.hpp"

using namespace kreisel;
using namespace reference_tests;

namespace {

using Vec = Eigen::Vector3d;
using Mat = Eigen::Matrix3d;

constexpr int body_size = 18;  // x, R column by column, v, omega

/// The residual F(t, y, y') of a model on spherical and revolute joints; y = (x, R, v, omega of each body; lambda of
/// each joint).
class Residual {
  public:
    explicit Residual(Model model) : model_(std::move(model)) {}

    int bodies() const { return static_cast<int>(model_.bodies.size()); }
    int size() const {
        int rows = 0;
        for (const Joint& joint : model_.joints) rows += rows_of(joint);
        return body_size * bodies() + rows;
    }
    bool is_differential(int i) const { return i < body_size * bodies(); }

    void start(double* y) const {
        for (const Body& body : model_.bodies) {
            const BodyState& s = body.start;
            for (int i = 0; i < 3; ++i) y[i] = to_double(s.x[i]), y[12 + i] = to_double(s.v[i]);
            for (int i = 0; i < 9; ++i) y[3 + i] = to_double(s.R(i % 3, i / 3));
            for (int i = 0; i < 3; ++i) y[15 + i] = to_double(s.omega[i]);
            y += body_size;
        }
    }

    void evaluate(double t, const double* y, const double* dy, double* F) const {
        const Vec g = gravity(t);
        for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
            const Body& body = model_.bodies[b];
            const std::size_t at = body_size * b;
            const Mat J = body.J.unaryExpr([](const Real& x) { return to_double(x); }).cast<double>();
            const Vec w = vec(y + at + 15);
            put(F + at, vec(dy + at) - vec(y + at + 12));
            for (int column = 0; column < 3; ++column) {
                const Vec rate = mat(y + at + 3) * w.cross(Vec::Unit(column));
                put(F + at + 3 + 3 * column, vec(dy + at + 3 + 3 * column) - rate);
            }
            put(F + at + 12, to_double(body.mass) * (vec(dy + at + 12) - g));
            put(F + at + 15, J * vec(dy + at + 15) + w.cross(J * w));
        }
        std::size_t row = body_size * model_.bodies.size();
        for (const Joint& joint : model_.joints) {
            put(F + row, Vec::Zero());
            add_end(joint.first, joint.r_first, 1, row, y, dy, F);
            add_end(joint.second, joint.r_second, -1, row, y, dy, F);
            for (int k = 0; k < rows_of(joint) - 3; ++k)
                add_angle(joint, k, row + 3 + static_cast<std::size_t>(k), y, dy, F);
            row += static_cast<std::size_t>(rows_of(joint));
        }
    }

    std::vector<BodyState> states(const double* y) const {
        std::vector<BodyState> result;
        for (int b = 0; b < bodies(); ++b, y += body_size)
            result.push_back(
                {vec(y).cast<Real>(), mat(y + 3).cast<Real>(), vec(y + 12).cast<Real>(), vec(y + 15).cast<Real>()});
        return result;
    }

  private:
    static Vec vec(const double* p) { return {p[0], p[1], p[2]}; }
    static Mat mat(const double* p) { return Eigen::Map<const Mat>(p); }
    static void put(double* p, const Vec& v) { p[0] = v[0], p[1] = v[1], p[2] = v[2]; }
    static Vec rounded(const Vec3& v) { return {to_double(v[0]), to_double(v[1]), to_double(v[2])}; }
    Vec gravity(double t) const {
        const Gravity& field = model_.gravity;
        return rounded(field.g) * (1 + to_double(field.amplitude) * std::sin(to_double(field.frequency) * t));
    }
    /// The joint's force on a body, and the acceleration of the body's point in the joint's row.
    static void add_end(int index, const Vec3& point, double sign, std::size_t row, const double* y, const double* dy,
                        double* F) {
        if (index == ground) return;
        const std::size_t at = body_size * static_cast<std::size_t>(index);
        const Vec r = rounded(point), lambda = vec(y + row), w = vec(y + at + 15);
        const Mat R = mat(y + at + 3);
        put(F + at + 12, vec(F + at + 12) + sign * lambda);
        put(F + at + 15, vec(F + at + 15) + sign * r.cross(R.transpose() * lambda));
        const Vec acceleration = vec(dy + at + 12) + R * (vec(dy + at + 15).cross(r) + w.cross(w.cross(r)));
        put(F + row, vec(F + row) + sign * acceleration);
    }

    static int rows_of(const Joint& joint) { return joint.type == "revolute" ? 5 : 3; }
    /// A direction fixed in a body, its first and its second rate, in space axes.
    struct Direction {
        Vec at, rate, rate2;
    };
    static Direction direction(int index, const Vec3& axis, const double* y, const double* dy) {
        const Vec a = rounded(axis);
        if (index == ground) return {a, Vec::Zero(), Vec::Zero()};
        const std::size_t at = body_size * static_cast<std::size_t>(index);
        const Mat R = mat(y + at + 3);
        const Vec w = vec(y + at + 15), alpha = vec(dy + at + 15);
        return {R * a, R * w.cross(a), R * (alpha.cross(a) + w.cross(w.cross(a)))};
    }
    /// The second rate of a.b, a the axis of the first body and b axis k of the second; the couple along a x b.
    static void add_angle(const Joint& joint, int k, std::size_t row, const double* y, const double* dy, double* F) {
        const Direction a = direction(joint.first, joint.axes_first.col(2), y, dy);
        const Direction b = direction(joint.second, joint.axes_second.col(k), y, dy);
        F[row] = a.rate2.dot(b.at) + 2 * a.rate.dot(b.rate) + a.at.dot(b.rate2);
        const auto turn = [&](int index, double sign) {
            if (index == ground) return;
            const std::size_t at = body_size * static_cast<std::size_t>(index);
            put(F + at + 15, vec(F + at + 15) + sign * y[row] * mat(y + at + 3).transpose() * a.at.cross(b.at));
        };
        turn(joint.first, 1), turn(joint.second, -1);
    }

    Model model_;
};

int residual(realtype t, N_Vector y, N_Vector dy, N_Vector F, void* data) {
    static_cast<const Residual*>(data)->evaluate(t, N_VGetArrayPointer(y), N_VGetArrayPointer(dy),
                                                 N_VGetArrayPointer(F));
    return 0;
}

/// All that IDA allocates, freed in reverse order.
template <class T>
using Owned = std::unique_ptr<std::remove_pointer_t<T>, void (*)(T)>;

Owned<N_Vector> zeros(int size, SUNContext context) {
    Owned<N_Vector> v(N_VNew_Serial(size, context), N_VDestroy);
    N_VConst(0, v.get());
    return v;
}

std::vector<BodyState> by_ida(const Model& model, double t_end, double tolerance) {
    Residual problem(model);
    SUNContext raw = nullptr;
    REQUIRE(SUNContext_Create(nullptr, &raw) == 0);
    const Owned<SUNContext> context(raw, [](SUNContext c) { SUNContext_Free(&c); });
    const int n = problem.size();
    const auto y = zeros(n, raw), dy = zeros(n, raw), id = zeros(n, raw);
    problem.start(N_VGetArrayPointer(y.get()));
    for (int i = 0; i < n; ++i) N_VGetArrayPointer(id.get())[i] = problem.is_differential(i) ? 1 : 0;
    const Owned<SUNMatrix> matrix(SUNDenseMatrix(n, n, raw), SUNMatDestroy);
    const Owned<SUNLinearSolver> solver(SUNLinSol_Dense(y.get(), matrix.get(), raw),
                                        [](SUNLinearSolver s) { SUNLinSolFree(s); });
    const std::unique_ptr<void, void (*)(void*)> ida(IDACreate(raw), [](void* memory) { IDAFree(&memory); });
    REQUIRE(IDAInit(ida.get(), residual, 0, y.get(), dy.get()) == IDA_SUCCESS);
    REQUIRE(IDASetUserData(ida.get(), &problem) == IDA_SUCCESS);
    REQUIRE(IDASStolerances(ida.get(), tolerance, tolerance) == IDA_SUCCESS);
    REQUIRE(IDASetMaxNumSteps(ida.get(), 1000000) == IDA_SUCCESS);
    REQUIRE(IDASetId(ida.get(), id.get()) == IDA_SUCCESS);
    REQUIRE(IDASetLinearSolver(ida.get(), solver.get(), matrix.get()) == IDA_SUCCESS);
    REQUIRE(IDACalcIC(ida.get(), IDA_YA_YDP_INIT, t_end) == IDA_SUCCESS);
    REQUIRE(IDASetStopTime(ida.get(), t_end) == IDA_SUCCESS);
    double t = 0;
    REQUIRE(IDASolve(ida.get(), t_end, &t, y.get(), dy.get(), IDA_NORMAL) >= 0);
    REQUIRE(t == t_end);
    return problem.states(N_VGetArrayPointer(y.get()));
}

/// Two bodies without symmetry on hinges that are not parallel.
Model hinged_pair() {
    Model model = models::bodies_in_a_row(2);
    models::join(model, ground, 0, "revolute", Vec3(1, -1, 2) / 3);
    models::join(model, 1, 0, "revolute", Vec3(1, 2, 0) / 3);
    model.gravity = {Vec3(1, -2, -9), Real(1) / 2, 3};
    project_start(model);
    return model;
}

double largest(const Distance& d) { return to_double(max(max(d.position, d.rotation), max(d.velocity, d.omega))); }

double difference(const Model& model, double tolerance) {
    return largest(distance(by_ida(model, 1, tolerance), confirmed_reference(model, Real(1)).states));
}

}  // namespace

TEST_CASE("the references agree with IDA of SUNDIALS, to its tolerance") {
    for (const Model& model : {standard_model("double_pendulum"), standard_model("forced_heavy_top"), hinged_pair()}) {
        const double rough = difference(model, 1e-7), fine = difference(model, 1e-10);
        CAPTURE(model.bodies.back().name, rough, fine);
        CHECK(fine < 1e-7);
        CHECK(fine < rough / 20);
    }
}

TEST_CASE("control: IDA sees a joint that is off by a millionth") {
    Model model = standard_model("double_pendulum");
    model.joints[1].r_second[0] += Real(1) / 1000000;
    const Distance d =
        distance(by_ida(model, 1, 1e-10), confirmed_reference(standard_model("double_pendulum"), Real(1)).states);
    CHECK(largest(d) > 1e-7);
    Model pair = hinged_pair();
    pair.joints[1].axes_first.col(2) += Vec3(1, 2, 0) / 1000000;
    CHECK(largest(distance(by_ida(pair, 1, 1e-10), confirmed_reference(hinged_pair(), Real(1)).states)) > 1e-7);
}
