// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/free_bodies.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <type_traits>

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
FreeBodies<Coordinates>::FreeBodies(Model model)
    : System(std::make_shared<Power<Factor>>(static_cast<int>(model.bodies.size()))),
      model_(std::move(model)),
      complement_(model_),
      relative_(model_.joints.size(), Mat3::Identity()),
      mu_(model_.joints.size(), Vec3::Zero()) {
    for (const Body& body : model_.bodies) nodes_.push_back({1 / body.mass, body.J, body.J.inverse()});
    for (const SphericalJoint& joint : model_.joints) {
        const auto node = [&](int body) { return body == ground ? nullptr : &nodes_[static_cast<std::size_t>(body)]; };
        links_.push_back({node(joint.first), node(joint.second), joint.first * Factor::size + 3,
                          joint.second * Factor::size + 3, joint.first * 6 + 3, joint.second * 6 + 3, joint.r_first,
                          joint.r_second});
    }
    find_anchored();
}

template <class Coordinates>
void FreeBodies<Coordinates>::find_anchored() {
    if (!model_.loads.empty()) return;
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
KREISEL_HOT Status FreeBodies<Coordinates>::anchored_accelerations(const Real& t, const Real* q, const Real* v,
                                                                   Real* dv) const {
    Vec3 modulated;
    const Gravity& gravity = model_.gravity;
    const Vec3& g = gravity.is_constant() ? gravity.g : (modulated = gravity.at(t));
    Real sum = 0;
    for (const Anchored& body : anchored_) {
        const Rotation R = mat3(q + 3);
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
Status FreeBodies<Coordinates>::refactor(const Real* q) {
    for (std::size_t j = 0; j < links_.size(); ++j) {
        const Link& link = links_[j];
        if (link.first) relative_[j].noalias() = mat3(q + link.second_R).transpose() * mat3(q + link.first_R);
    }
    return complement_.factor(relative_.data());
}

template <class Coordinates>
void FreeBodies<Coordinates>::apply_reactions() {
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
KREISEL_HOT Status FreeBodies<Coordinates>::accelerations(const Real& t, const Real* q, const Real* v, Real* dv,
                                                          Real* lambda) {
    if (!anchored_.empty() && !lambda) return anchored_accelerations(t, q, v, dv);
    const Vec3 g = model_.gravity.at(t);
    const Real* R = q + 3;
    const Real* omega = v + 3;
    for (Node& node : nodes_) {
        const Vec3 w = vec3(omega), Jw = node.J * w;
        node.A = mat3(R).transpose() * g;
        node.dw = node.J_inverse * Jw.cross(w);
        R += Factor::size, omega += 6;
    }
    for (const Load& load : model_.loads)
        nodes_[static_cast<std::size_t>(load.body)].push(load.in_body_axes(t, rotation(q, load.body)));
    if (const Status status = prepare_joints(q); status != Status::ok) return status;
    Vec3* rho = mu_.data();
    const Mat3* E = relative_.data();
    for (const Link& link : links_) {
        *rho = -link.second->point_acceleration(link.r_second, vec3(v + link.second_omega));
        if (link.first) *rho += *E * link.first->point_acceleration(link.r_first, vec3(v + link.first_omega));
        ++rho, ++E;
    }
    if (!links_.empty()) apply_reactions();
    Real sum = 0;
    R = q + 3;
    for (const Node& node : nodes_) {
        const Vec3 a = Coordinates::acceleration(mat3(R), node.A, vec3(v + 3), vec3(v));
        sum += a.sum() + node.dw.sum();
        store(a, dv), store(node.dw, dv + 3);
        R += Factor::size, v += 6, dv += 6;
    }
    if (lambda) report_multipliers(q, lambda);
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

template <class Coordinates>
Status FreeBodies<Coordinates>::solve_kkt(const Real&, const Real* q, const Real* f, const Real* c, Real* a,
                                          Real* lambda) {
    const Real* R = q + 3;
    for (Node& node : nodes_) {
        node.A = node.inverse_mass * Coordinates::to_body(mat3(R), vec3(f));
        node.dw = node.J_inverse * vec3(f + 3);
        R += Factor::size, f += 6;
    }
    if (const Status status = prepare_joints(q); status != Status::ok) return status;
    Vec3* rho = mu_.data();
    const Mat3* E = relative_.data();
    for (const Link& link : links_) {
        *rho = -link.second->point_acceleration(link.r_second) - mat3(q + link.second_R).transpose() * vec3(c);
        if (link.first) *rho += *E * link.first->point_acceleration(link.r_first);
        ++rho, ++E, c += 3;
    }
    if (!links_.empty()) apply_reactions();
    Real sum = 0;
    R = q + 3;
    for (const Node& node : nodes_) {
        const Vec3 out = Coordinates::from_body(mat3(R), node.A);
        sum += out.sum() + node.dw.sum();
        store(out, a), store(node.dw, a + 3);
        R += Factor::size, a += 6;
    }
    if (lambda) report_multipliers(q, lambda);
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

template <class Coordinates>
void FreeBodies<Coordinates>::report_multipliers(const Real* q, Real* lambda) const {
    for (std::size_t j = 0; j < links_.size(); ++j)
        store(Vec3(mat3(q + links_[j].second_R) * mu_[j]), lambda + 3 * j);
}

template <class Coordinates>
void FreeBodies<Coordinates>::mass(const Real*, Real* blocks) const {
    for (const Body& body : model_.bodies) {
        Eigen::Map<Eigen::Matrix<Real, 6, 6>> block(blocks);
        block.setZero();
        block.template topLeftCorner<3, 3>() = body.mass * Mat3::Identity();
        block.template bottomRightCorner<3, 3>() = body.J;
        blocks += 36;
    }
}

template <class Coordinates>
void FreeBodies<Coordinates>::applied_force(const Real& t, const Real* q, const Real*, Real* f) const {
    const Vec3 g = model_.gravity.at(t);
    for (int i = 0; i < bodies(); ++i) {
        const Real& mass = model_.bodies[static_cast<std::size_t>(i)].mass;
        store(Vec3(mass * Coordinates::from_space(rotation(q, i), g)), f + 6 * i);
        store(Vec3(Vec3::Zero()), f + 6 * i + 3);
    }
    for (const Load& load : model_.loads) {
        const Rotation R = rotation(q, load.body);
        const auto [force, torque] = load.in_body_axes(t, R);
        Real* mine = f + 6 * load.body;
        store(Vec3(vec3(mine) + Coordinates::from_body(R, force)), mine);
        store(Vec3(vec3(mine + 3) + torque), mine + 3);
    }
}

template <class Coordinates>
void FreeBodies<Coordinates>::gyroscopic_force(const Real*, const Real* v, Real* f) const {
    for (const Body& body : model_.bodies) {
        const Vec3 w = vec3(v + 3);
        store(Coordinates::gyroscopic(body.mass, w, vec3(v)), f);
        store(Vec3(-w.cross(body.J * w)), f + 3);
        v += 6, f += 6;
    }
}

template <class Coordinates>
void FreeBodies<Coordinates>::position_residual(const Real&, const Real* q, Real* phi) const {
    for (const SphericalJoint& joint : model_.joints) {
        store(Vec3(point(q, joint.first, joint.r_first) - point(q, joint.second, joint.r_second)), phi);
        phi += 3;
    }
}

template <class Coordinates>
void FreeBodies<Coordinates>::jacobian(const Real&, const Real* q, Real* C) const {
    Eigen::Map<MatX> rows(C, constraints(), velocities());
    rows.setZero();
    const auto add = [&](Eigen::Index row, int body, const Vec3& r, int sign) {
        if (body == ground) return;
        const Rotation R = rotation(q, body);
        rows.template block<3, 3>(row, 6 * body) = sign * Coordinates::linear_columns(R);
        rows.template block<3, 3>(row, 6 * body + 3) = -sign * R * hat(r);
    };
    Eigen::Index row = 0;
    for (const SphericalJoint& joint : model_.joints) {
        add(row, joint.first, joint.r_first, 1);
        add(row, joint.second, joint.r_second, -1);
        row += 3;
    }
}

template <class Coordinates>
void FreeBodies<Coordinates>::velocity_residual(const Real&, const Real* q, const Real* v, Real* residual) const {
    const auto velocity = [&](int body, const Vec3& r) -> Vec3 {
        if (body == ground) return Vec3::Zero();
        const Rotation R = rotation(q, body);
        return Coordinates::space_velocity(R, linear(v, body)) + R * angular(v, body).cross(r);
    };
    for (const SphericalJoint& joint : model_.joints) {
        store(Vec3(velocity(joint.first, joint.r_first) - velocity(joint.second, joint.r_second)), residual);
        residual += 3;
    }
}

template <class Coordinates>
bool FreeBodies<Coordinates>::ambient_jacobian(const Real&, const Real* q, const Real* v, Real* G) const {
    if (!std::is_same_v<Coordinates, MixedCoordinates>) return false;
    const Eigen::Index m = constraints(), size = group().size();
    Eigen::Map<MatX> rows(G, 2 * m, size + velocities());
    rows.setZero();
    // Point x + R r and its velocity x' + R (omega x r), both linear in the columns R_k of R.
    const auto add = [&](Eigen::Index row, int body, const Vec3& r, int sign) {
        if (body == ground) return;
        const Mat3 identity = sign * Mat3::Identity();
        const Vec3 wr = angular(v, body).cross(r);
        const Eigen::Index x = body * Factor::size, dx = size + 6 * body;
        rows.template block<3, 3>(row, x) = identity;
        rows.template block<3, 3>(m + row, dx) = identity;
        rows.template block<3, 3>(m + row, dx + 3) = -sign * rotation(q, body) * hat(r);
        for (Eigen::Index k = 0; k < 3; ++k) {
            rows.template block<3, 3>(row, x + 3 + 3 * k) = r[k] * identity;
            rows.template block<3, 3>(m + row, x + 3 + 3 * k) = wr[k] * identity;
        }
    };
    Eigen::Index row = 0;
    for (const SphericalJoint& joint : model_.joints) {
        add(row, joint.first, joint.r_first, 1);
        add(row, joint.second, joint.r_second, -1);
        row += 3;
    }
    return true;
}

template <class Coordinates>
void FreeBodies<Coordinates>::acceleration_bias(const Real&, const Real* q, const Real* v, Real* xi) const {
    // d/dt of the point velocity with v' = 0: centripetal acceleration, and in SE(3) the turning of R V.
    const auto bias = [&](int body, const Vec3& r) -> Vec3 {
        if (body == ground) return Vec3::Zero();
        const Vec3 w = angular(v, body);
        const Vec3 turning = -Coordinates::gyroscopic(Real(1), w, linear(v, body));
        return rotation(q, body) * (w.cross(w.cross(r)) + turning);
    };
    for (const SphericalJoint& joint : model_.joints) {
        store(Vec3(bias(joint.second, joint.r_second) - bias(joint.first, joint.r_first)), xi);
        xi += 3;
    }
}

template <class Coordinates>
void FreeBodies<Coordinates>::row_scale(Real* scale) const {
    for (const SphericalJoint& joint : model_.joints) {
        const Real size = max(Real(joint.r_first.norm()), Real(joint.r_second.norm()));
        std::fill_n(scale, 3, size > 0 ? size : Real(1));
        scale += 3;
    }
}

template <class Coordinates>
Real FreeBodies<Coordinates>::potential(const Real& t, const Real* q) const {
    const Vec3 g = model_.gravity.at(t);
    Real sum = 0;
    for (int i = 0; i < bodies(); ++i)
        sum -= model_.bodies[static_cast<std::size_t>(i)].mass * g.dot(position(q, i));
    return sum;
}

template <class Coordinates>
void FreeBodies<Coordinates>::read(const Real* y, BodyState* states) const {
    const Real* v = y + group().size();
    for (int i = 0; i < bodies(); ++i) {
        const Rotation R = rotation(y, i);
        states[i] = {position(y, i), R, Coordinates::space_velocity(R, linear(v, i)), angular(v, i)};
    }
}

template <class Coordinates>
void FreeBodies<Coordinates>::write(const BodyState* states, Real* y) const {
    Real* v = y + group().size();
    for (int i = 0; i < bodies(); ++i) {
        const BodyState& state = states[i];
        store(state.x, y + i * Factor::size), store(state.R, y + i * Factor::size + 3);
        store(Coordinates::from_space_velocity(rotation(y, i), state.v), v + 6 * i), store(state.omega, v + 6 * i + 3);
    }
}

template class FreeBodies<MixedCoordinates>;
template class FreeBodies<ScrewCoordinates>;

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
