// SPDX-License-Identifier: BSD-3-Clause
//
// Loads: given forces and torques on one body. Configs write them as "force" and "torque".
#pragma once

#include <vector>

#include "mechanics/forces/wrench.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A force (N) and a torque (N m), both times 1 + amplitude sin(frequency t), given in space axes or in axes that turn
/// with the body; the force acts at `point` (body axes, from the mass centre), frequency in rad/s.
struct Load {
    enum class Axes { space, body };
    int body = 0;
    Axes axes = Axes::space;
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    Real amplitude = 0, frequency = 0;
    Vec3 point = Vec3::Zero();
    /// At time t; R is the body's rotation.
    template <class Rotation>
    Wrench in_body_axes(const Real& t, const Rotation& R) const {
        const Real factor = 1 + amplitude * sin(frequency * t);
        Wrench wrench{factor * force, factor * torque};
        if (axes == Axes::space) wrench = {R.transpose() * wrench.force, R.transpose() * wrench.torque};
        wrench.torque += point.cross(wrench.force);
        return wrench;
    }

    // As mechanics/forces/forces.hpp asks of every force.
    template <class MotionOf, class AngleOf, class Push>
    void act(const Real& t, const MotionOf& motion, const AngleOf& /*angle*/, const Push& push) const {
        push(body, in_body_axes(t, motion(body).R));
    }
    template <class MotionOf, class Push>
    void damp(const MotionOf& /*motion*/, const Push& /*push*/) const {}
    bool is_damped() const { return false; }
    /// -force . (x + R point) (J), 0 at the origin, of a dead load.
    template <class MotionOf, class AngleOf>
    Real energy(const MotionOf& motion, const AngleOf& /*angle*/) const {
        return is_conservative() ? Real(-force.dot(motion(body).point(point))) : Real(0);
    }
    /// A dead load: a constant force in space. The work of a torque depends on the way.
    bool is_conservative() const { return axes == Axes::space && amplitude == 0 && torque.isZero(0); }
    bool is_internal() const { return false; }
    bool touches(int other) const { return other == body; }
    bool may_push(int other) const { return touches(other) && !force.isZero(0); }
    const Vec3* centre_on(int /*body*/) const { return nullptr; }
};

/// Those of a model.
struct Loads {
    std::vector<Load> loads;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
