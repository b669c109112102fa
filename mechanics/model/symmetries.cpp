// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/model/symmetries.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "mechanics/model/scales.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Data written as decimals satisfy such conditions to round-off if they are meant to.
const Real slack = 64 * epsilon;

bool parallel(const Vec3& a, const Vec3& e) { return a.cross(e).norm() <= slack * a.norm() * e.norm(); }
bool orthogonal(const Vec3& a, const Vec3& e) { return abs(a.dot(e)) <= slack * a.norm() * e.norm(); }
bool meets(const Line& line, const Vec3& point) {
    const Vec3 d = point - line.P;
    return d.cross(line.e).norm() <= slack * max(Real(point.norm()), Real(line.P.norm()));
}

/// The ground side of a joint.
struct Anchor {
    JointType type;
    Vec3 point, axis;
};

std::vector<Anchor> anchors(const Model& model) {
    std::vector<Anchor> all;
    for (const Joint& joint : model.joints) {
        if (joint.first == ground) all.push_back({joint.type, joint.r_first, joint.axes_first.col(2)});
        if (joint.second == ground) all.push_back({joint.type, joint.r_second, joint.axes_second.col(2)});
    }
    return all;
}

/// A rolling disk turns about no axis: the momentum of a symmetry that lets it slip is not constant.
bool turns_freely(const Anchor& anchor, const Line& axis) {
    if (anchor.type->has(FreeMotion::turn_about_point)) return meets(axis, anchor.point);
    if (!parallel(anchor.axis, axis.e)) return false;
    if (anchor.type->has(FreeMotion::turn_about_normal)) return true;
    return (anchor.type->has(FreeMotion::turn_about_axis) || anchor.type->has(FreeMotion::turn_about_two)) &&
           meets(axis, anchor.point);
}

bool shifts_freely(const Anchor& anchor, const Vec3& e) {
    return (anchor.type->has(FreeMotion::slide_along_axis) && parallel(anchor.axis, e)) ||
           (anchor.type->has(FreeMotion::slide_across_axis) && orthogonal(anchor.axis, e));
}

bool holds_to_ground(const Joint& joint) { return joint.first == ground || joint.second == ground; }

/// Calls f(body) for the bodies, or the ground, that a force touches.
template <class Force, class F>
void each_touched(const Force& force, F f) {
    if constexpr (requires { force.body; }) {
        f(force.body);
    } else {
        f(force.first), f(force.second);
    }
}

/// Unit axis e such that J = a e e^T + b (I - e e^T) to working precision, or nothing.
std::optional<Vec3> symmetry_axis(const Mat3& J) {
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(J);
    const Vec3& moments = principal.eigenvalues();
    const Real equal = 16 * epsilon * moments[2];
    std::optional<Vec3> axis;
    if (moments[1] - moments[0] <= equal)
        axis = principal.eigenvectors().col(2);
    else if (moments[2] - moments[1] <= equal)
        axis = principal.eigenvectors().col(0);
    if (axis && axis->sum() < 0) axis = -*axis;
    return axis;
}

/// The point of a joint on one of its bodies, in body axes.
const Vec3& end(const Joint& joint, int number) { return joint.first == number ? joint.r_first : joint.r_second; }

/// Whether a point r of a body (body axes) lies on the axis e through its mass centre, to round-off of the size of the
/// body.
bool is_central(const Vec3& r, const Body& body, const Vec3& e) {
    return r.cross(e).norm() <= 16 * epsilon * (r.norm() + radius_of_gyration(body));
}

/// Whether the joint exerts no moment about the axis e through the mass centre of the body.
bool leaves_spin(const Joint& joint, const Body& body, int number, const Vec3& e) {
    const bool central = is_central(end(joint, number), body, e);
    const Mat3& axes = joint.first == number ? joint.axes_first : joint.axes_second;
    if (joint.type->has(FreeMotion::turn_about_point)) return central;
    // Forces act on the axis, couples turn about normals of it.
    return joint.type->has(FreeMotion::turn_about_axis) && central && parallel(axes.col(2), e);
}

}  // namespace

bool is_conservative(const Model& model) {
    return model.gravity.is_constant() && model.all([](const auto& force) { return force.is_conservative(); });
}

bool is_invariant_under_rotation(const Model& model, const Line& axis) {
    if (!(model.gravity.g.isZero(0) || parallel(model.gravity.g, axis.e))) return false;
    const auto all = anchors(model);
    return std::all_of(all.begin(), all.end(), [&](const Anchor& a) { return turns_freely(a, axis); }) &&
           model.all([&](const auto& force) {
               if (force.is_internal()) return true;
               const Vec3* anchor = force.touches(ground) ? force.centre_on(ground) : nullptr;
               return anchor && meets(axis, *anchor);
           });
}

bool is_invariant_under_translation(const Model& model, const Vec3& e) {
    if (!orthogonal(model.gravity.g, e)) return false;
    const auto all = anchors(model);
    return std::all_of(all.begin(), all.end(), [&](const Anchor& a) { return shifts_freely(a, e); }) &&
           model.all([](const auto& force) { return force.is_internal(); });
}

Vec3 pivot(const Model& model) {
    for (const Anchor& anchor : anchors(model))
        if (!anchor.type->has(FreeMotion::slide_across_axis)) return anchor.point;
    const Vec3* point = nullptr;
    model.each([&](const auto& force, std::size_t) {
        if (!point && force.touches(ground)) point = force.centre_on(ground);
    });
    return point ? *point : Vec3(Vec3::Zero());
}

std::vector<BodyTies> ties_of_bodies(const Model& model) {
    std::vector<BodyTies> all(model.bodies.size());
    for (const Joint& joint : model.joints)
        for (const int body : {joint.first, joint.second})
            if (body != ground) all[static_cast<std::size_t>(body)].joints.push_back(&joint);
    model.each([&](const auto& force, std::size_t) {
        each_touched(force, [&](int body) {
            if (body != ground) all[static_cast<std::size_t>(body)].centres.push_back(force.centre_on(body));
        });
    });
    return all;
}

std::optional<Vec3> free_spin_axis(const Body& body, int number, const BodyTies& ties) {
    if (body.point) return std::nullopt;
    const auto axis = symmetry_axis(body.J);
    if (!axis) return std::nullopt;
    const auto joint_leaves = [&](const Joint* joint) { return leaves_spin(*joint, body, number, *axis); };
    const auto force_leaves = [&](const Vec3* centre) { return centre && is_central(*centre, body, *axis); };
    const bool free = std::all_of(ties.joints.begin(), ties.joints.end(), joint_leaves) &&
                      std::all_of(ties.centres.begin(), ties.centres.end(), force_leaves);
    return free ? axis : std::nullopt;
}

std::optional<KovalevskayaTop> kovalevskaya_top(const Body& body, int number, const BodyTies& ties,
                                                const Gravity& gravity) {
    if (ties.joints.size() != 1 || !ties.joints[0]->type->is_ball() || !holds_to_ground(*ties.joints[0]) ||
        !ties.centres.empty() || body.point || !gravity.is_constant() || gravity.g.isZero(0))
        return std::nullopt;
    const Vec3 lever = -end(*ties.joints[0], number);
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(inertia_about(body, lever));
    const Vec3& moments = principal.eigenvalues();  // in increasing order: C, A, B
    const Real equal = slack * moments[2];
    if (abs(moments[2] - moments[1]) > equal || abs(moments[1] - 2 * moments[0]) > equal) return std::nullopt;
    const Vec3 e3 = principal.eigenvectors().col(0);  // of either sign: q and gamma_2 change theirs with it
    const Real l = lever.norm(), g = gravity.g.norm();
    if (l == 0 || !orthogonal(lever, e3)) return std::nullopt;
    const Vec3 e1 = (lever - lever.dot(e3) * e3).normalized();
    KovalevskayaTop top;
    top.axes << e1, e3.cross(e1), e3;
    top.c = body.mass * g * l / moments[0];
    top.up = -gravity.g / g;
    return top;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
