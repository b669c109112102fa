// SPDX-License-Identifier: BSD-3-Clause
//
// The discrete Moser-Veselov algorithm in its matrix form [moserveselov1991]: with R+ = R W in principal axes and a
// diagonal D of moments I~_1 = D_2 + D_3, ...,
//   h m~ = W D - D W^T,   h m+~ = D W - W^T D.
// D follows from the first equation; 1/I~ is then an affine function of 1/I, the identity for order 2.
#include <Eigen/LU>

#include "mechanics/free_body/free_rotation.hpp"
#include "tests/judges/steps/recorded_steps.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Model generic_free_body() {
    Model model = models::standard("free_top");
    model.bodies[0].J << 3, 1, -1, 1, 5, 1, -1, 1, 4;
    model.bodies[0].start.omega = Vec3(2, -1, 3);
    model.bodies[0].start.v = Vec3(1, 2, -1);
    return model;
}

Objection moser_veselov_objection(const Method& method) {
    const Model model = generic_free_body();
    const auto& [I, Q] = principal_axes(model.bodies[0].J);
    const Real h = Real(1) / 16;
    for (const std::string& formulation : models::applicable(model)) {
        if (!stepping::runs_on(method, model, formulation)) continue;
        RecordedRun run(method, {}, model, formulation, h, 1);
        std::vector<BodyState> ends;
        for (const RecordedState& state : run.states) {
            VecX y(state.q.size() + state.v.size());
            y << state.q, state.v;
            ends.emplace_back(), run.system().read(y.data(), &ends.back());
        }
        const Mat3 W = Q.transpose() * ends[0].R.transpose() * ends[1].R * Q;
        const Vec3 m = I.cwiseProduct(Q.transpose() * ends[0].omega),
                   m_next = I.cwiseProduct(Q.transpose() * ends[1].omega);
        Mat3 from_D;
        from_D << 0, W(2, 1), -W(1, 2), -W(2, 0), 0, W(0, 2), W(1, 0), -W(0, 1), 0;
        const Vec3 D = from_D.inverse() * (h * m);
        const Vec3 inverse = Vec3(D[1] + D[2], D[2] + D[0], D[0] + D[1]).cwiseInverse(), plain = I.cwiseInverse();
        Violations found;
        found.see("h m+~ = D W - W^T D", h * m_next - vee(Mat3(D.asDiagonal() * W - W.transpose() * D.asDiagonal())));
        found.see("x+ = x + h v", ends[1].x - ends[0].x - h * ends[0].v);
        found.see("1/I~ is affine in 1/I", VecX::Constant(1, (inverse[0] - inverse[1]) * (plain[1] - plain[2]) -
                                                                 (inverse[1] - inverse[2]) * (plain[0] - plain[1])));
        if (method.description.order.configuration == 2) found.see("I~ = I", inverse - plain);
        const Objection objection = found.objection(1000 * epsilon);
        if (!objection.empty()) return objection + " as " + formulation;
    }
    return "";
}

KREISEL_STEP_CHECK("variational/dmv", moser_veselov_objection);
KREISEL_STEP_CHECK("variational/dmv4", moser_veselov_objection);
KREISEL_STEP_CHECK("variational/dmv6", moser_veselov_objection);
KREISEL_STEP_CHECK("variational/dmv8", moser_veselov_objection);
KREISEL_STEP_CHECK("variational/dmv10", moser_veselov_objection);

}  // namespace

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
