// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/quaternion_form.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "lie/so3.hpp"
#include "mechanics/formulation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

Mat3 rotation_of_quaternion(const Real* a) {
    const Real s = 2 / (a[0] * a[0] + a[1] * a[1] + a[2] * a[2] + a[3] * a[3]);
    const Real x = s * a[1], y = s * a[2], z = s * a[3];
    const Real wx = a[0] * x, wy = a[0] * y, wz = a[0] * z;
    const Real xx = a[1] * x, xy = a[1] * y, xz = a[1] * z;
    const Real yy = a[2] * y, yz = a[2] * z, zz = a[3] * z;
    Mat3 R;
    R << 1 - (yy + zz), xy - wz, xz + wy,  //
        xy + wz, 1 - (xx + zz), yz - wx,   //
        xz - wy, yz + wx, 1 - (xx + yy);
    return R;
}

void quaternion_of_rotation(const Mat3& R, Real* a) {
    const Vec3 u = SO3::log(R) / 2;
    const Real t2 = u.squaredNorm();
    a[0] = cos(sqrt(t2));
    store(Vec3(sinc(t2) * u), a + 1);
}

QuaternionForm::QuaternionForm(const Model& model)
    : model_(model),
      system_(make_system(model, "SO3xR3")),
      bodies_(system_->bodies()),
      y_(static_cast<std::size_t>(system_->state_group().size())),
      acceleration_(static_cast<std::size_t>(system_->velocities())),
      rows_(static_cast<std::size_t>(system_->constraints())) {}

std::vector<Real> QuaternionForm::start() const {
    std::vector<Real> w(static_cast<std::size_t>(dimension()));
    Real* p = w.data();
    for (const Body& body : model_.bodies) {
        store(body.start.x, p);
        quaternion_of_rotation(body.start.R, p + 3);
        store(body.start.v, p + 7), store(body.start.omega, p + 10);
        p += body_size;
    }
    for (const TorsionSpring& spring : model_.torsion_springs) *p++ = 2 * pi() * Real(spring.turns);
    return w;
}

std::vector<SpringAngle> QuaternionForm::angles(const Real* w) {
    load(w);
    std::vector<SpringAngle> angles(model_.torsion_springs.size());
    system_->read_angles(y_.data(), angles.data());
    return angles;
}

void QuaternionForm::settle(Real* w) {
    Real* theta = w + body_size * bodies_;
    for (const SpringAngle& angle : angles(w)) *theta++ = angle.theta;
}

Motion QuaternionForm::motion(const Real* w, int body) const {
    if (body == ground) return {};
    w += body * body_size;
    const Mat3 R = rotation_of_quaternion(w + 3);
    return {vec3(w), R, R.transpose() * vec3(w + 7), vec3(w + 10)};
}

/// Flat state of SO3xR3: (x, R) of each body, the angles of torsion springs, then (x', omega) of each body.
void QuaternionForm::load(const Real* w) {
    Real* q = y_.data();
    Real* v = system_->v(q);
    for (int i = 0; i < bodies_; ++i, w += body_size, q += 12, v += 6) {
        store(vec3(w), q), store(rotation_of_quaternion(w + 3), q + 3);
        store(vec3(w + 7), v), store(vec3(w + 10), v + 3);
    }
    std::copy_n(w, system_->torsion_springs(), q);
}

Status QuaternionForm::rate(const Real& t, const Real* w, Real* dw) {
    load(w);
    const Real* v = system_->v(y_.data());
    if (const Status s = system_->accelerations(t, y_.data(), v, acceleration_.data(), nullptr); s != Status::ok)
        return s;
    Real* theta_rate = dw + body_size * bodies_;
    for (const TorsionSpring& spring : model_.torsion_springs)
        *theta_rate++ = turn(spring, motion(w, spring.first), motion(w, spring.second)).rate;
    const Real* dv = acceleration_.data();
    for (int i = 0; i < bodies_; ++i, w += body_size, dw += body_size, dv += 6) {
        const Vec3 a = vec3(w + 4), half = vec3(w + 10) / 2;
        store(vec3(w + 7), dw);
        dw[3] = -a.dot(half);
        store(Vec3(w[3] * half + a.cross(half)), dw + 4);
        store(vec3(dv), dw + 7), store(vec3(dv + 3), dw + 10);
    }
    return Status::ok;
}

std::vector<BodyState> QuaternionForm::states(const Real* w) const {
    std::vector<BodyState> bodies;
    for (int i = 0; i < bodies_; ++i, w += body_size)
        bodies.push_back({vec3(w), rotation_of_quaternion(w + 3), vec3(w + 7), vec3(w + 10)});
    return bodies;
}

Status QuaternionForm::multipliers(const Real& t, const Real* w, std::vector<Real>& lambda) {
    load(w);
    lambda.resize(rows_.size());
    const Real* v = system_->v(y_.data());
    return system_->accelerations(t, y_.data(), v, acceleration_.data(), lambda.data());
}

QuaternionForm::Residual QuaternionForm::residual(const Real& t, const Real* w) {
    load(w);
    const auto norm = [&](int rows) { return Eigen::Map<const VecX>(rows_.data(), rows).norm(); };
    system_->position_residual(t, y_.data(), rows_.data());
    const Real position = norm(system_->position_constraints());
    system_->velocity_residual(t, y_.data(), system_->v(y_.data()), rows_.data());
    return {position, norm(system_->constraints())};
}

QuaternionForm::AccelerationScale QuaternionForm::acceleration_scale(const Real& t, const Real* w) {
    std::vector<Real> lambda;
    AccelerationScale squares;
    if (multipliers(t, w, lambda) != Status::ok) return squares;
    const Real *q = y_.data(), *v = system_->v(q);
    const Eigen::Index n = system_->velocities();
    VecX applied(n), gyroscopic(n);
    system_->applied_force(t, q, v, applied.data());
    system_->gyroscopic_force(q, v, gyroscopic.data());
    MatX C(static_cast<Eigen::Index>(lambda.size()), n);
    system_->jacobian(t, q, C.data());
    for (std::size_t b = 0; b < model_.bodies.size(); ++b) {
        const auto size = [&](Eigen::Index part) {
            const Eigen::Index at = 6 * static_cast<Eigen::Index>(b) + part;
            Real sum = applied.segment<3>(at).norm() + gyroscopic.segment<3>(at).norm();
            for (Eigen::Index row = 0; row < C.rows(); ++row)
                sum += C.block<1, 3>(row, at).norm() * abs(lambda[static_cast<std::size_t>(row)]);
            return sum;
        };
        const Real linear = size(0) / model_.bodies[b].mass;
        const Real angular = size(3) * model_.bodies[b].J.inverse().norm();
        squares.linear += linear * linear, squares.angular += angular * angular;
    }
    return {sqrt(squares.linear), sqrt(squares.angular)};
}

bool QuaternionForm::has_redundant_rows() const {
    const ConstraintRank rank = system_->constraint_rank();
    return rank.rank < rank.rows;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
