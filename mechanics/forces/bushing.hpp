// SPDX-License-Identifier: BSD-3-Clause
//
// Bushings: six springs and six dampers between a frame of one body and a frame of another.
#pragma once

#include <array>
#include <vector>

#include "mechanics/forces/wrench.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Between the frame (r_first, axes_first) of the first body and (r_second, axes_second) of the second. p is the place
/// of the second frame in the first, and Rx(q_1) Ry(q_2) Rz(q_3) its rotation: the force on the second body is
/// -stiffness_i p_i - damping_i p_i' along the axes of the first frame, at the place of the second, and the torque has
/// the components -stiffness_i q_i - damping_i q_i' that do work on q_i'. The first body gets the opposite of both.
/// |q_2| stays below a quarter turn; q_1 and q_3 are in (-pi, pi]. This is Simbody's LinearBushing [sherman2011].
struct Bushing {
    static constexpr const char* type = "bushing";
    int first = ground, second = 0;
    Vec3 r_first = Vec3::Zero(), r_second = Vec3::Zero();
    Mat3 axes_first = Mat3::Identity(), axes_second = Mat3::Identity();
    /// Of p (N/m, N s/m) and of q (N m/rad, N m s/rad).
    std::array<Vec3, 2> stiffness = {Vec3::Zero(), Vec3::Zero()}, damping = {Vec3::Zero(), Vec3::Zero()};

    // As mechanics/forces/forces.hpp asks of every force.
    template <class MotionOf, class AngleOf, class Push>
    void act(const Real& /*t*/, const MotionOf& motion, const AngleOf& /*angle*/, const Push& push) const {
        push_pair(*this, exerted(stiffness, motion(first), motion(second)), push);
    }
    template <class MotionOf, class Push>
    void damp(const MotionOf& motion, const Push& push) const {
        if (!is_damped()) return;
        push_pair(*this, exerted({Vec3::Zero(), Vec3::Zero()}, motion(first), motion(second)), push);
    }
    bool is_damped() const { return !(damping[0].isZero(0) && damping[1].isZero(0)); }
    template <class MotionOf, class AngleOf>
    Real energy(const MotionOf& motion, const AngleOf& /*angle*/) const {
        return stored(motion(first), motion(second));
    }
    bool is_conservative() const { return !is_damped(); }
    bool is_internal() const { return !touches(ground); }
    bool touches(int body) const { return first == body || second == body; }
    bool may_push(int body) const { return touches(body) && !(stiffness[0].isZero(0) && damping[0].isZero(0)); }
    const Vec3* centre_on(int /*body*/) const { return nullptr; }

    /// With the damping, and a stiffness of p and of q.
    WrenchPair exerted(const std::array<Vec3, 2>& stiffness_now, const Motion& one, const Motion& other) const;
    /// sum_i (stiffness_i p_i^2 + stiffness_i q_i^2) / 2 (J).
    Real stored(const Motion& one, const Motion& other) const;
};

/// Those of a model.
struct Bushings {
    std::vector<Bushing> bushings;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
