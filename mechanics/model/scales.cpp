// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/model/scales.hpp"

#include <utility>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Vec3 point_in_space(const Model& model, int body, const Vec3& r) {
    if (body == ground) return r;
    const BodyState& start = model.bodies[static_cast<std::size_t>(body)].start;
    return start.x + start.R * r;
}

/// Calls f(point in space axes) for all mass centres and joint points.
template <class F>
void each_point(const Model& model, F f) {
    for (const Body& body : model.bodies) f(body.start.x);
    for (const Joint& joint : model.joints)
        f(point_in_space(model, joint.first, joint.r_first)), f(point_in_space(model, joint.second, joint.r_second));
}

}  // namespace

Real radius_of_gyration(const Body& body) {
    const Real radius = body.point ? Real(0) : Real(sqrt(body.J.trace() / (2 * body.mass)));
    return isfinite(radius) ? radius : Real(0);
}

Real extent(const Model& model) {
    if (model.bodies.empty()) return 0;
    const Vec3 near = model.bodies[0].start.x;  // differences from a point of the mechanism: its place cancels
    Vec3 sum = Vec3::Zero();
    Real count = 0, radius = 0, largest = 0;
    each_point(model, [&](const Vec3& point) { sum += point - near, count += 1; });
    const Vec3 mean = sum / count;
    each_point(model, [&](const Vec3& point) { radius = max(radius, Real((point - near - mean).norm())); });
    for (const Body& body : model.bodies) largest = max(largest, radius_of_gyration(body));
    return max(Real(2 * radius), largest);
}

Real remoteness(const Model& model) {
    Real largest = 0;
    each_point(model, [&](const Vec3& point) { largest = max(largest, Real(point.norm())); });
    return largest;
}

Real joint_length(const Model& model, const Joint& joint) {
    Real length = joint.length;
    for (const auto& [body, arm] : {std::pair(joint.first, joint.r_first), std::pair(joint.second, joint.r_second)})
        if (body != ground) {
            const Real radius = radius_of_gyration(model.bodies[static_cast<std::size_t>(body)]);
            length = max(length, max(Real(arm.norm()), radius));
        }
    if (length > 0) return length;
    const Real size = extent(model);
    return size > 0 ? size : Real(1);
}

std::vector<Real> body_lengths(const Model& model) {
    std::vector<Real> lengths;
    for (const Body& body : model.bodies) lengths.push_back(radius_of_gyration(body));
    for (const Joint& joint : model.joints)
        for (const auto& [body, arm] : {std::pair(joint.first, joint.r_first), std::pair(joint.second, joint.r_second)})
            if (body != ground) {
                Real& length = lengths[static_cast<std::size_t>(body)];
                length = max(length, Real(arm.norm()));
            }
    return lengths;
}

Real mass_unit(const Model& model) {
    Real largest = 0;
    for (const Body& body : model.bodies)
        if (isfinite(body.mass)) largest = max(largest, body.mass);
    return largest > 0 ? power_of_two_below(largest) : Real(1);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
