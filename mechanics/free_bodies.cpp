// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/free_bodies.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <type_traits>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// omega x (omega x r).
Vec3 centripetal(const Vec3& omega, const Vec3& r) { return omega.cross(omega.cross(r)); }

}  // namespace

template <class Coordinates>
FreeBodies<Coordinates>::FreeBodies(Model model)
    : System(std::make_shared<Power<Factor>>(static_cast<int>(model.bodies.size()))),
      model_(std::move(model)),
      complement_(model_),
      A_(model_.bodies.size()),
      dw_(model_.bodies.size()),
      relative_(model_.joints.size(), Mat3::Identity()),
      mu_(3 * model_.joints.size()) {
    for (const Body& body : model_.bodies) inertia_.push_back({body.mass, 1 / body.mass, body.J, body.J.inverse()});
}

template <class Coordinates>
Status FreeBodies<Coordinates>::prepare_joints(const Real* q) {
    if (complement_.is_constant()) return complement_.status();
    for (std::size_t j = 0; j < relative_.size(); ++j) {
        const SphericalJoint& joint = model_.joints[j];
        if (joint.first != ground)
            relative_[j].noalias() = rotation(q, joint.second).transpose() * rotation(q, joint.first);
    }
    return complement_.factor(relative_.data());
}

template <class Coordinates>
void FreeBodies<Coordinates>::apply_reactions() {
    complement_.solve(mu_.data());
    for (std::size_t j = 0; j < relative_.size(); ++j) {
        const SphericalJoint& joint = model_.joints[j];
        const Vec3 mu = vec3(&mu_[3 * j]);
        const auto b = static_cast<std::size_t>(joint.second);
        A_[b] += inertia_[b].inverse_mass * mu;
        dw_[b] += inertia_[b].J_inverse * joint.r_second.cross(mu);
        if (joint.first == ground) continue;
        const auto a = static_cast<std::size_t>(joint.first);
        const Vec3 on_first = relative_[j].transpose() * mu;
        A_[a] -= inertia_[a].inverse_mass * on_first;
        dw_[a] -= inertia_[a].J_inverse * joint.r_first.cross(on_first);
    }
}

template <class Coordinates>
Status FreeBodies<Coordinates>::accelerations(const Real& t, const Real* q, const Real* v, Real* dv, Real* lambda) {
    const Vec3 g = model_.gravity.at(t);
    for (std::size_t i = 0; i < inertia_.size(); ++i) {
        const int body = static_cast<int>(i);
        const Vec3 w = angular(v, body), Jw = inertia_[i].J * w;
        A_[i] = rotation(q, body).transpose() * g;
        dw_[i] = inertia_[i].J_inverse * Jw.cross(w);
    }
    if (const Status status = prepare_joints(q); status != Status::ok) return status;
    for (std::size_t j = 0; j < relative_.size(); ++j) {
        const SphericalJoint& joint = model_.joints[j];
        Vec3 rho = -point_acceleration(joint.second, joint.r_second) -
                   centripetal(angular(v, joint.second), joint.r_second);
        if (joint.first != ground)
            rho += relative_[j] * (point_acceleration(joint.first, joint.r_first) +
                                   centripetal(angular(v, joint.first), joint.r_first));
        store(rho, &mu_[3 * j]);
    }
    if (!relative_.empty()) apply_reactions();
    Real sum = 0;
    for (std::size_t i = 0; i < inertia_.size(); ++i) {
        const int body = static_cast<int>(i);
        const Vec3 a = Coordinates::acceleration(rotation(q, body), A_[i], angular(v, body), linear(v, body));
        sum += a.sum() + dw_[i].sum();
        store(a, dv + 6 * i), store(dw_[i], dv + 6 * i + 3);
    }
    if (lambda) report_multipliers(q, lambda);
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

template <class Coordinates>
Status FreeBodies<Coordinates>::solve_kkt(const Real&, const Real* q, const Real* f, const Real* c, Real* a,
                                          Real* lambda) {
    for (std::size_t i = 0; i < inertia_.size(); ++i) {
        const int body = static_cast<int>(i);
        A_[i] = inertia_[i].inverse_mass * Coordinates::to_body(rotation(q, body), linear(f, body));
        dw_[i] = inertia_[i].J_inverse * angular(f, body);
    }
    if (const Status status = prepare_joints(q); status != Status::ok) return status;
    for (std::size_t j = 0; j < relative_.size(); ++j) {
        const SphericalJoint& joint = model_.joints[j];
        Vec3 rho = -point_acceleration(joint.second, joint.r_second) - to_joint_axes(q, joint, vec3(c + 3 * j));
        if (joint.first != ground) rho += relative_[j] * point_acceleration(joint.first, joint.r_first);
        store(rho, &mu_[3 * j]);
    }
    if (!relative_.empty()) apply_reactions();
    Real sum = 0;
    for (std::size_t i = 0; i < inertia_.size(); ++i) {
        const Vec3 out = Coordinates::from_body(rotation(q, static_cast<int>(i)), A_[i]);
        sum += out.sum() + dw_[i].sum();
        store(out, a + 6 * i), store(dw_[i], a + 6 * i + 3);
    }
    if (lambda) report_multipliers(q, lambda);
    return isfinite(sum) ? Status::ok : Status::non_finite;
}

template <class Coordinates>
void FreeBodies<Coordinates>::report_multipliers(const Real* q, Real* lambda) const {
    for (std::size_t j = 0; j < relative_.size(); ++j)
        store(Vec3(rotation(q, model_.joints[j].second) * vec3(&mu_[3 * j])), lambda + 3 * j);
}

template <class Coordinates>
void FreeBodies<Coordinates>::mass(const Real*, Real* blocks) const {
    for (const Inertia& inertia : inertia_) {
        Eigen::Map<Eigen::Matrix<Real, 6, 6>> block(blocks);
        block.setZero();
        block.template topLeftCorner<3, 3>() = inertia.mass * Mat3::Identity();
        block.template bottomRightCorner<3, 3>() = inertia.J;
        blocks += 36;
    }
}

template <class Coordinates>
void FreeBodies<Coordinates>::applied_force(const Real& t, const Real* q, const Real*, Real* f) const {
    const Vec3 g = model_.gravity.at(t);
    for (std::size_t i = 0; i < inertia_.size(); ++i) {
        store(Vec3(inertia_[i].mass * Coordinates::from_space(rotation(q, static_cast<int>(i)), g)), f + 6 * i);
        store(Vec3(Vec3::Zero()), f + 6 * i + 3);
    }
}

template <class Coordinates>
void FreeBodies<Coordinates>::gyroscopic_force(const Real*, const Real* v, Real* f) const {
    for (std::size_t i = 0; i < inertia_.size(); ++i) {
        const int body = static_cast<int>(i);
        const Vec3 w = angular(v, body);
        store(Coordinates::gyroscopic(inertia_[i].mass, w, linear(v, body)), f + 6 * i);
        store(Vec3(-w.cross(inertia_[i].J * w)), f + 6 * i + 3);
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
        const Mat3 R = rotation(q, body);
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
        const Mat3 R = rotation(q, body);
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
        return rotation(q, body) * (centripetal(w, r) + turning);
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
    for (std::size_t i = 0; i < inertia_.size(); ++i) sum -= inertia_[i].mass * g.dot(position(q, static_cast<int>(i)));
    return sum;
}

template <class Coordinates>
void FreeBodies<Coordinates>::read(const Real* y, BodyState* states) const {
    const Real* v = y + group().size();
    for (int i = 0; i < bodies(); ++i) {
        const Mat3 R = rotation(y, i);
        states[i] = {position(y, i), R, Coordinates::space_velocity(R, linear(v, i)), angular(v, i)};
    }
}

template <class Coordinates>
void FreeBodies<Coordinates>::write(const BodyState* states, Real* y) const {
    Real* v = y + group().size();
    for (int i = 0; i < bodies(); ++i) {
        const BodyState& state = states[i];
        store(state.x, y + i * Factor::size), store(state.R, y + i * Factor::size + 3);
        store(Coordinates::from_space_velocity(state.R, state.v), v + 6 * i), store(state.omega, v + 6 * i + 3);
    }
}

template class FreeBodies<MixedCoordinates>;
template class FreeBodies<ScrewCoordinates>;

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
