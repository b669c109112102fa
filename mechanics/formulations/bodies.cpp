// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/formulations/bodies.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <type_traits>

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class Coordinates>
Bodies<Coordinates>::Bodies(Model model)
    : System(configurations(std::make_shared<Power<Factor>>(static_cast<int>(model.bodies.size())), model)),
      model_(std::move(model)),
      turns_(model_),
      spherical_(all_spherical(model_)) {
    for (const Body& body : model_.bodies) J_inverse_.push_back(body.J.inverse());
    for (const Joint& joint : model_.joints) {
        places_.push_back({rows_of(joint.type), position_rows_of(joint.type), position_rows_, 0});
        position_rows_ += places_.back().position;
    }
    rows_ = position_rows_;
    for (Place& place : places_) {
        place.first_velocity = rows_;
        rows_ += place.all - place.position;
    }
}

template <class Coordinates>
Motion Bodies<Coordinates>::motion(const Real* q, const Real* v, int body) {
    if (body == ground) return {};
    const auto R = rotation(q, body);
    Motion motion{position(q, body), R};
    if (v) motion.V = R.transpose() * Coordinates::space_velocity(R, linear(v, body)), motion.omega = angular(v, body);
    return motion;
}

template <class Coordinates>
void Bodies<Coordinates>::mass(const Real*, Real* blocks) const {
    for (const Body& body : model_.bodies) {
        Eigen::Map<Mat6> block(blocks);
        block.setZero();
        block.template topLeftCorner<3, 3>() = body.mass * Mat3::Identity();
        block.template bottomRightCorner<3, 3>() = body.J;
        blocks += 36;
    }
}

template <class Coordinates>
void Bodies<Coordinates>::solve_mass(const Real*, const Real* f, Real* a) const {
    for (std::size_t i = 0; i < model_.bodies.size(); ++i, f += 6, a += 6) {
        store(Vec3(inverse_mass(model_.bodies[i]) * vec3(f)), a);
        store(Vec3(J_inverse_[i] * vec3(f + 3)), a + 3);
    }
}

template <class Coordinates>
void Bodies<Coordinates>::applied_force(const Real& t, const Real* q, const Real* v, Real* f) const {
    const Vec3 g = model_.gravity.at(t);
    for (int i = 0; i < bodies(); ++i) {
        const Real& mass = model_.bodies[static_cast<std::size_t>(i)].mass;
        store(Vec3(mass * Coordinates::from_space(rotation(q, i), g)), f + 6 * i);
        store(Vec3(Vec3::Zero()), f + 6 * i + 3);
    }
    for_each_wrench(
        model_, t, [&](int body) { return motion(q, v, body); },
        [&](std::size_t i, const Turn& turn) { return turns_.angle(i, turn, t, labels(q)); },
        [&](int body, const Wrench& wrench) {
            Real* mine = f + 6 * body;
            store(Vec3(vec3(mine) + Coordinates::from_body(rotation(q, body), wrench.force)), mine);
            store(Vec3(vec3(mine + 3) + wrench.torque), mine + 3);
        });
}

template <class Coordinates>
void Bodies<Coordinates>::gyroscopic_force(const Real*, const Real* v, Real* f) const {
    for (const Body& body : model_.bodies) {
        const Vec3 w = vec3(v + 3);
        store(Coordinates::gyroscopic(body.mass, w, vec3(v)), f);
        store(Vec3(-w.cross(body.J * w)), f + 3);
        v += 6, f += 6;
    }
}

template <class Coordinates>
template <class F>
void Bodies<Coordinates>::each_joint(const Real& t, const Real* q, const Real* v, F f) const {
    JointRows rows;
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
        const Joint& joint = model_.joints[j];
        write_rows(joint, t, motion(q, v, joint.first), motion(q, v, joint.second), rows);
        f(j, rows);
    }
}

template <class Coordinates>
void Bodies<Coordinates>::point_positions(const Real* q, Real* phi) const {
    const auto point = [&](int body, const Vec3& r) -> Vec3 {
        return body == ground ? r : Vec3(position(q, body) + rotation(q, body) * r);
    };
    for (const Joint& joint : model_.joints) {
        store(Vec3(point(joint.first, joint.r_first) - point(joint.second, joint.r_second)), phi);
        phi += 3;
    }
}

template <class Coordinates>
void Bodies<Coordinates>::point_velocities(const Real* q, const Real* v, Real* residual) const {
    const auto velocity = [&](int body, const Vec3& r) -> Vec3 {
        if (body == ground) return Vec3::Zero();
        const auto R = rotation(q, body);
        return Coordinates::space_velocity(R, linear(v, body)) + R * angular(v, body).cross(r);
    };
    for (const Joint& joint : model_.joints) {
        store(Vec3(velocity(joint.first, joint.r_first) - velocity(joint.second, joint.r_second)), residual);
        residual += 3;
    }
}

template <class Coordinates>
void Bodies<Coordinates>::position_residual(const Real& t, const Real* q, Real* phi) const {
    if (spherical_) return point_positions(q, phi);
    each_joint(t, q, nullptr, [&](std::size_t j, const JointRows& rows) {
        for (int k = 0; k < places_[j].position; ++k) phi[row(j, k)] = rows.phi[k];
    });
}

template <class Coordinates>
void Bodies<Coordinates>::jacobian(const Real& t, const Real* q, Real* C) const {
    Eigen::Map<MatX> matrix(C, constraints(), velocities());
    matrix.setZero();
    const auto add = [&](int row, int body, const Mat6& side, int k) {
        if (body == ground) return;
        const Vec3 force = side.template block<3, 1>(0, k), torque = side.template block<3, 1>(3, k);
        matrix.template block<1, 3>(row, 6 * body) = Coordinates::from_body(rotation(q, body), force).transpose();
        matrix.template block<1, 3>(row, 6 * body + 3) = torque.transpose();
    };
    each_joint(t, q, nullptr, [&](std::size_t j, const JointRows& rows) {
        for (int k = 0; k < rows.count; ++k) {
            add(row(j, k), model_.joints[j].first, rows.first, k);
            add(row(j, k), model_.joints[j].second, rows.second, k);
        }
    });
}

template <class Coordinates>
void Bodies<Coordinates>::complement_diagonal(const Real& t, const Real* q, Real* diagonal) const {
    each_joint(t, q, nullptr, [&](std::size_t j, const JointRows& rows) {
        const auto mobility = [&](int body, const Mat6& side, int k) -> Real {
            if (body == ground) return 0;
            const auto i = static_cast<std::size_t>(body);
            const Vec3 force = side.template block<3, 1>(0, k), torque = side.template block<3, 1>(3, k);
            return inverse_mass(model_.bodies[i]) * force.squaredNorm() + torque.dot(J_inverse_[i] * torque);
        };
        for (int k = 0; k < rows.count; ++k)
            diagonal[row(j, k)] =
                mobility(model_.joints[j].first, rows.first, k) + mobility(model_.joints[j].second, rows.second, k);
    });
}

template <class Coordinates>
void Bodies<Coordinates>::velocity_bias(const Real& t, const Real* q, Real* b) const {
    each_joint(t, q, nullptr, [&](std::size_t j, const JointRows& rows) {
        for (int k = 0; k < rows.count; ++k) b[row(j, k)] = rows.rate_bias[k];
    });
}

template <class Coordinates>
void Bodies<Coordinates>::row_velocities(const Real& t, const Real* q, const Real* v, int share, Real* residual) const {
    each_joint(t, q, v, [&](std::size_t j, const JointRows& rows) {
        const Joint& joint = model_.joints[j];
        const Motion first = motion(q, v, joint.first), second = motion(q, v, joint.second);
        for (int k = 0; k < rows.count; ++k) {
            Real sum = share * rows.rate_bias[k];
            if (joint.first != ground)
                sum += rows.first.template block<3, 1>(0, k).dot(first.V) +
                       rows.first.template block<3, 1>(3, k).dot(first.omega);
            if (joint.second != ground)
                sum += rows.second.template block<3, 1>(0, k).dot(second.V) +
                       rows.second.template block<3, 1>(3, k).dot(second.omega);
            residual[row(j, k)] = sum;
        }
    });
}

template <class Coordinates>
void Bodies<Coordinates>::velocity_residual(const Real& t, const Real* q, const Real* v, Real* residual) const {
    spherical_ ? point_velocities(q, v, residual) : row_velocities(t, q, v, 1, residual);
}

template <class Coordinates>
void Bodies<Coordinates>::apply_jacobian(const Real& t, const Real* q, const Real* v, Real* product) const {
    spherical_ ? point_velocities(q, v, product) : row_velocities(t, q, v, 0, product);
}

template <class Coordinates>
void Bodies<Coordinates>::apply_jacobian_transpose(const Real& t, const Real* q, const Real* lambda, Real* f) const {
    std::fill_n(f, this->velocities(), Real(0));
    const auto add = [&](int body, const Vec3& force, const Vec3& torque) {  // in body axes
        Real* mine = f + 6 * body;
        store(Vec3(vec3(mine) + Coordinates::from_body(rotation(q, body), force)), mine);
        store(Vec3(vec3(mine + 3) + torque), mine + 3);
    };
    if (spherical_) {
        const auto pull = [&](int body, const Vec3& force, const Vec3& r) {
            if (body == ground) return;
            const Vec3 turned = rotation(q, body).transpose() * force;
            add(body, turned, r.cross(turned));
        };
        for (const Joint& joint : model_.joints) {
            pull(joint.first, vec3(lambda), joint.r_first), pull(joint.second, -vec3(lambda), joint.r_second);
            lambda += 3;
        }
        return;
    }
    each_joint(t, q, nullptr, [&](std::size_t j, const JointRows& rows) {
        Vec6 mine = Vec6::Zero();
        for (int k = 0; k < rows.count; ++k) mine[k] = lambda[row(j, k)];
        const auto pull = [&](int body, const Mat6& side) {
            if (body == ground) return;
            const Vec6 wrench = side.leftCols(rows.count).lazyProduct(mine.head(rows.count));
            add(body, wrench.template head<3>(), wrench.template tail<3>());
        };
        pull(model_.joints[j].first, rows.first), pull(model_.joints[j].second, rows.second);
    });
}

/// C v' = xi. A = R^T x'' differs from the coordinates' v' by what the frame's turning adds.
template <class Coordinates>
void Bodies<Coordinates>::acceleration_bias(const Real& t, const Real* q, const Real* v, Real* xi) const {
    each_joint(t, q, v, [&](std::size_t j, const JointRows& rows) {
        const Joint& joint = model_.joints[j];
        const auto turning = [&](int body, const Mat6& side, int k) -> Real {
            if (body == ground) return 0;
            return -side.template block<3, 1>(0, k).dot(
                Coordinates::gyroscopic(Real(1), angular(v, body), linear(v, body)));
        };
        for (int k = 0; k < rows.count; ++k)
            xi[row(j, k)] = -rows.acceleration_bias[k] - turning(joint.first, rows.first, k) -
                            turning(joint.second, rows.second, k);
    });
}

template <class Coordinates>
bool Bodies<Coordinates>::has_ambient_jacobian() const {
    return std::is_same_v<Coordinates, SO3xR3Coordinates> && spherical_;
}

template <class Coordinates>
void Bodies<Coordinates>::ambient_jacobian(const Real&, const Real* q, const Real* v, Real* G) const {
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
    for (const Joint& joint : model_.joints) {
        add(row, joint.first, joint.r_first, 1);
        add(row, joint.second, joint.r_second, -1);
        row += 3;
    }
}

template <class Coordinates>
Status Bodies<Coordinates>::reactions(const Real& t, const Real* q, const Real*, const Real* lambda,
                                      JointReaction* out) {
    std::array<Real, most_rows> mine{};
    for (std::size_t j = 0; j < model_.joints.size(); ++j) {
        const Joint& joint = model_.joints[j];
        for (int k = 0; k < places_[j].all; ++k) mine[static_cast<std::size_t>(k)] = lambda[row(j, k)];
        out[j] = reaction_of(joint, t, motion(q, nullptr, joint.first), motion(q, nullptr, joint.second), mine.data());
    }
    return Status::ok;
}

template <class Coordinates>
void Bodies<Coordinates>::row_scale(Real* scale) const {
    for (std::size_t j = 0; j < places_.size(); ++j)
        for (int k = 0; k < places_[j].all; ++k) scale[row(j, k)] = kreisel::row_scale(model_, model_.joints[j], k);
}

template <class Coordinates>
void Bodies<Coordinates>::position_scale(const Real* q, Real* size) const {
    const auto reach = [&](int body, const Vec3& r) {
        return body == ground ? Real(r.norm()) : Real(position(q, body).norm() + r.norm());
    };
    for (std::size_t j = 0; j < places_.size(); ++j) {
        const Joint& joint = model_.joints[j];
        const Real length = reach(joint.first, joint.r_first) + reach(joint.second, joint.r_second) + joint.length;
        for (int k = 0; k < places_[j].position; ++k)
            size[row(j, k)] = is_direction_row(joint.type, k) ? Real(2) : length;
    }
}

template <class Coordinates>
KREISEL_HOT void Bodies<Coordinates>::to_space_axes(const Real* q, const Real* v, Real* turned) const {
    for (int i = 0; i < bodies(); ++i, v += 6, turned += 6) {
        const auto R = rotation(q, i);
        const Vec3 linear = Coordinates::space_velocity(R, vec3(v)), angular = R * vec3(v + 3);
        store(linear, turned), store(angular, turned + 3);
    }
}

template <class Coordinates>
KREISEL_HOT void Bodies<Coordinates>::from_space_axes(const Real* q, const Real* turned, Real* v) const {
    for (int i = 0; i < bodies(); ++i, turned += 6, v += 6) {
        const auto R = rotation(q, i);
        const Vec3 linear = Coordinates::from_space_velocity(R, vec3(turned)),
                   angular = R.transpose() * vec3(turned + 3);
        store(linear, v), store(angular, v + 3);
    }
}

template <class Coordinates>
Real Bodies<Coordinates>::potential(const Real& t, const Real* q) const {
    const Vec3 g = model_.gravity.at(t);
    const auto at = [&](int body) { return motion(q, nullptr, body); };
    Real sum = stored_energy(model_, at, [&](std::size_t i) { return turns_.read(i, labels(q), at).theta; });
    for (int i = 0; i < bodies(); ++i) sum -= model_.bodies[static_cast<std::size_t>(i)].mass * g.dot(position(q, i));
    return sum;
}

template <class Coordinates>
void Bodies<Coordinates>::read(const Real* y, BodyState* states) const {
    const Real* v = y + group().size();
    for (int i = 0; i < bodies(); ++i) {
        const auto R = rotation(y, i);
        states[i] = {position(y, i), R, Coordinates::space_velocity(R, linear(v, i)), angular(v, i)};
    }
}

template <class Coordinates>
void Bodies<Coordinates>::write(const BodyState* states, Real* y) const {
    Real* v = y + group().size();
    for (int i = 0; i < bodies(); ++i) {
        const BodyState& state = states[i];
        Real* mine = y + i * Factor::size;
        store(state.x, mine), Coordinates::Rotations::save(state.R, mine + 3);
        store(Coordinates::from_space_velocity(rotation(y, i), state.v), v + 6 * i), store(state.omega, v + 6 * i + 3);
    }
}

template <class Coordinates>
Status Bodies<Coordinates>::begin_step(const Real& t, const Real& h, const Real* y) {
    const Real* v = y + group().size();
    return turns_.begin_step(t, h, labels(y), [&](int body) { return motion(y, v, body); });
}

template <class Coordinates>
Status Bodies<Coordinates>::end_step(Status result, const Real& t, Real* y) {
    const Real* v = y + group().size();
    return turns_.end_step(result, t, labels(y), [&](int body) { return motion(y, v, body); });
}

template <class Coordinates>
void Bodies<Coordinates>::read_angles(const Real* q, SpringAngle* angles) const {
    for (std::size_t i = 0; i < model_.torsion_springs.size(); ++i)
        angles[i] = turns_.read(i, labels(q), [&](int body) { return motion(q, nullptr, body); });
}

template class Bodies<SO3xR3Coordinates>;
template class Bodies<SE3Coordinates>;
template class Bodies<S3xR3Coordinates>;

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
