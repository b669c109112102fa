// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/start/positions.hpp"

#include <algorithm>

#include "lie/so3.hpp"
#include "mechanics/start/least_correction.hpp"
#include "mechanics/start/start_tolerances.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// By which angle the axis of a joint's first body is off that of the second (rad), and about which line it turns onto
/// it (unit, axes of the first body).
struct Tilt {
    Real angle = 0;
    Vec3 line = Vec3::Zero();
};

bool keeps_axes_parallel(const Joint& joint) {
    const auto& rows = joint.type->rows;
    return std::find(rows.begin(), rows.end(), orthogonal(3, 1)) != rows.end();
}

bool holds_teeth_only(const Joint& joint) {
    return joint.type->has(Primitive::mesh) || joint.type->has(Primitive::rack);
}

Tilt tilt_of(const Model& model, std::size_t j) {
    const Joint& joint = model.joints[j];
    if (!keeps_axes_parallel(joint)) return {};
    const auto rotation = [&](int body) {
        return body == ground ? Mat3(Mat3::Identity()) : model.bodies[static_cast<std::size_t>(body)].start.R;
    };
    const Vec3 a = joint.axes_first.col(2);
    const Vec3 b = rotation(joint.first).transpose() * rotation(joint.second) * joint.axes_second.col(2);
    const Vec3 line = a.cross(b);
    const Real angle = atan2(line.norm(), a.dot(b));
    if (angle > pi() - Real(1) / 1000000)
        throw ParameterError("", model.name_of_joint(j) +
                                     ": expected axes less than 180 degrees apart, got opposite ones: which way they "
                                     "should turn is not determined");
    return {angle, angle > 0 ? Vec3(line.normalized()) : line};
}

bool has_couplings(const Model& model) {
    return std::any_of(model.joints.begin(), model.joints.end(),
                       [](const Joint& joint) { return joint.type->has(Primitive::helix) || holds_teeth_only(joint); });
}

/// The model with a share of all tilts left, and without the rows that couple turns: these count from where axes lie in
/// the end, and on the way there would turn bodies about them.
Model uncoupled(const Model& model, const std::vector<Tilt>& tilts, const Real& share) {
    Model stage = model;
    stage.joints.clear();
    for (std::size_t j = 0; j < tilts.size(); ++j) {
        Joint joint = model.joints[j];
        if (holds_teeth_only(joint)) continue;
        if (joint.type->has(Primitive::helix)) joint.type = "cylindrical";
        joint.axes_first = SO3::exp(tilts[j].angle * share * tilts[j].line) * joint.axes_first;
        stage.joints.push_back(joint);
    }
    return stage;
}

}  // namespace

void project_positions(StartState& start) {
    constexpr int most_steps = 50;
    const System& system = start.system();
    VecX phi = start.position_residual();
    for (int i = 0; i < most_steps; ++i) {
        const Real before = start.size_of(phi);
        const VecX step = least_correction(start, system.position_constraints(), phi);
        system.group().append_exp(start.q(), step.data(), start.q());
        phi = start.position_residual();
        if (is_round_off(start, phi)) break;
        if (i > 2 && start.size_of(phi) > before / 2) break;  // round-off amplified, or no convergence
    }
}

Model with_aligned_axes(const Model& model) {
    std::vector<Tilt> tilts;
    for (std::size_t j = 0; j < model.joints.size(); ++j) tilts.push_back(tilt_of(model, j));
    Real widest = 0;
    for (const Tilt& tilt : tilts) widest = max(widest, tilt.angle);
    const int stages = static_cast<int>(ceil(8 * widest / pi())), last = has_couplings(model) ? 0 : 1;
    Model aligned = model;
    for (int left = stages - 1; left >= last; --left) {
        const Model stage = uncoupled(aligned, tilts, Real(left) / Real(stages));
        StartState start(stage);
        project_positions(start);
        std::vector<BodyState> states(model.bodies.size());
        start.system().read(start.q(), states.data());
        for (std::size_t i = 0; i < states.size(); ++i) aligned.bodies[i].start = states[i];
    }
    return aligned;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
