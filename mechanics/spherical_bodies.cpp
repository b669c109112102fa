// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/spherical_bodies.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
bool SphericalBodies<Coordinates>::fits(const Model& model) {
    return std::all_of(model.joints.begin(), model.joints.end(), [](const Joint& joint) {
        return joint.type == JointType::spherical && joint.second != ground;
    });
}

template <class Coordinates>
SphericalBodies<Coordinates>::SphericalBodies(Model data)
    : Base(std::move(data)),
      complement_(this->model()),
      relative_(this->model().joints.size(), Mat3::Identity()),
      mu_(relative_.size(), Vec3::Zero()),
      forces_(has_forces(this->model())) {
    for (const Body& body : this->model().bodies) nodes_.push_back({1 / body.mass, body.J, body.J.inverse()});
    for (const Joint& joint : this->model().joints) {
        const auto node = [&](int body) { return body == ground ? nullptr : &nodes_[static_cast<std::size_t>(body)]; };
        links_.push_back({node(joint.first), node(joint.second), joint.r_first, joint.r_second});
    }
    find_anchored();
}

template <class Coordinates>
void SphericalBodies<Coordinates>::find_anchored() {
    if (forces_) return;
    std::vector<const Link*> anchor(nodes_.size(), nullptr);
    for (const Link& link : links_) {
        const Link*& mine = anchor[static_cast<std::size_t>(link.second - nodes_.data())];
        if (link.first || mine || complement_.status() != Status::ok) return;
        mine = &link;
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const Node& node = nodes_[i];
        const Vec3 r = anchor[i] ? anchor[i]->r_second : Vec3(Vec3::Zero());
        const Mat3 J_inverse_r = node.J_inverse * hat(r);
        const Mat3 S = node.inverse_mass * Mat3::Identity() - hat(r) * J_inverse_r;
        anchored_.push_back({node.inverse_mass, node.J, node.J_inverse, J_inverse_r,
                             anchor[i] ? Mat3(S.inverse()) : Mat3(Mat3::Zero()), r});
    }
}

template <class Coordinates>
KREISEL_HOT Status SphericalBodies<Coordinates>::anchored_accelerations(const Real& t, const Real* q, const Real* v,
                                                                   Real* dv) const {
    Vec3 modulated;
    const Gravity& gravity = this->model().gravity;
    const Vec3& g = gravity.is_constant() ? gravity.g : (modulated = gravity.at(t));
    Real sum = 0;
    for (const Anchored& body : anchored_) {
        const auto R = Coordinates::Rotations::rotation(q + 3);
        const Vec3 w = vec3(v + 3), r = body.r, Jw = body.J * w;
        Vec3 A = R.transpose() * g;
        Vec3 dw = body.J_inverse * Jw.cross(w);
        const Vec3 mu = body.S_inverse * (A + dw.cross(r) + w.cross(w.cross(r)));  // minus the joint's force
        A -= body.inverse_mass * mu;
        dw -= body.J_inverse_r * mu;
        const Vec3 a = Coordinates::acceleration(R, A, w, vec3(v));
        sum += (a[0] + a[1] + a[2]) + (dw[0] + dw[1] + dw[2]);
        store(a, dv), store(dw, dv + 3);
        q += Factor::size, v += 6, dv += 6;
    }
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

template <class Coordinates>
Status SphericalBodies<Coordinates>::refactor() {
    Mat3* E = relative_.data();
    for (const Link& link : links_) {
        if (link.first) E->noalias() = link.second->R.transpose() * link.first->R;
        ++E;
    }
    return complement_.factor(relative_.data());
}

template <class Coordinates>
void SphericalBodies<Coordinates>::apply_reactions() {
    complement_.solve(mu_.data());
    const Vec3* mu = mu_.data();
    const Mat3* E = relative_.data();
    for (const Link& link : links_) {
        link.second->apply(*mu, link.r_second);
        if (link.first) link.first->apply(-(E->transpose() * *mu), link.r_first);
        ++mu, ++E;
    }
}

template <class Coordinates>
KREISEL_HOT Status SphericalBodies<Coordinates>::accelerations(const Real& t, const Real* q, const Real* v, Real* dv,
                                                               Real* lambda) {
    if (!anchored_.empty() && !lambda) return anchored_accelerations(t, q, v, dv);
    const Vec3 g = this->model().gravity.at(t);
    const Real* pose = q;
    const Real* velocity = v;
    for (Node& node : nodes_) {
        node.R = Coordinates::Rotations::rotation(pose + 3);
        node.omega = vec3(velocity + 3);
        const Vec3 Jw = node.J * node.omega;
        node.A = node.R.transpose() * g;
        node.dw = node.J_inverse * Jw.cross(node.omega);
        pose += Factor::size, velocity += 6;
    }
    if (forces_)
        for_each_wrench(this->model(), t, [&](int body) { return motion(q, v, body); },
                        [&](int body, const Wrench& wrench) { nodes_[static_cast<std::size_t>(body)].push(wrench); });
    if (const Status status = prepare_joints(); status != Status::ok) return status;
    Vec3* rho = mu_.data();
    const Mat3* E = relative_.data();
    for (const Link& link : links_) {
        *rho = -link.second->point_acceleration(link.r_second);
        if (link.first) *rho += *E * link.first->point_acceleration(link.r_first);
        ++rho, ++E;
    }
    if (!links_.empty()) apply_reactions();
    Real sum = 0;
    for (const Node& node : nodes_) {
        const Vec3 a = Coordinates::acceleration(node.R, node.A, vec3(v + 3), vec3(v));
        sum += a.sum() + node.dw.sum();
        store(a, dv), store(node.dw, dv + 3);
        v += 6, dv += 6;
    }
    if (lambda) report_multipliers(lambda);
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

template <class Coordinates>
Status SphericalBodies<Coordinates>::solve_kkt(const Real&, const Real* q, const Real* f, const Real* c, Real* a,
                                               Real* lambda) {
    for (Node& node : nodes_) {
        node.R = Coordinates::Rotations::rotation(q + 3);
        node.omega.setZero();
        node.A = node.inverse_mass * Coordinates::to_body(node.R, vec3(f));
        node.dw = node.J_inverse * vec3(f + 3);
        q += Factor::size, f += 6;
    }
    if (const Status status = prepare_joints(); status != Status::ok) return status;
    Vec3* rho = mu_.data();
    const Mat3* E = relative_.data();
    for (const Link& link : links_) {
        *rho = -link.second->point_acceleration(link.r_second) - link.second->R.transpose() * vec3(c);
        if (link.first) *rho += *E * link.first->point_acceleration(link.r_first);
        ++rho, ++E, c += 3;
    }
    if (!links_.empty()) apply_reactions();
    Real sum = 0;
    for (const Node& node : nodes_) {
        const Vec3 out = Coordinates::from_body(node.R, node.A);
        sum += out.sum() + node.dw.sum();
        store(out, a), store(node.dw, a + 3);
        a += 6;
    }
    if (lambda) report_multipliers(lambda);
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

template <class Coordinates>
void SphericalBodies<Coordinates>::report_multipliers(Real* lambda) const {
    for (std::size_t j = 0; j < links_.size(); ++j) store(Vec3(links_[j].second->R * mu_[j]), lambda + 3 * j);
}

template <class Coordinates>
void SphericalBodies<Coordinates>::position_residual(const Real&, const Real* q, Real* phi) const {
    const auto point = [&](int body, const Vec3& r) -> Vec3 {
        return body == ground ? r : Vec3(position(q, body) + rotation(q, body) * r);
    };
    for (const Joint& joint : this->model().joints) {
        store(Vec3(point(joint.first, joint.r_first) - point(joint.second, joint.r_second)), phi);
        phi += 3;
    }
}

template <class Coordinates>
void SphericalBodies<Coordinates>::velocity_residual(const Real&, const Real* q, const Real* v, Real* residual) const {
    const auto velocity = [&](int body, const Vec3& r) -> Vec3 {
        if (body == ground) return Vec3::Zero();
        const auto R = rotation(q, body);
        return Coordinates::space_velocity(R, linear(v, body)) + R * angular(v, body).cross(r);
    };
    for (const Joint& joint : this->model().joints) {
        store(Vec3(velocity(joint.first, joint.r_first) - velocity(joint.second, joint.r_second)), residual);
        residual += 3;
    }
}

template class SphericalBodies<MixedCoordinates>;
template class SphericalBodies<ScrewCoordinates>;
template class SphericalBodies<QuaternionCoordinates>;

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
