// SPDX-License-Identifier: BSD-3-Clause
//
// Torsion springs and dampers about an axis that two bodies share. Their angles count full turns (mechanics/turns.hpp).
#pragma once

#include <vector>

#include "mechanics/forces/wrench.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// About the third axis that two frames share: torque -stiffness (theta - angle) - damping theta' on the second body
/// and its opposite on the first. theta is the angle from the first frame's first axis to the second's, full turns
/// included: at the start it is the one in (-pi, pi] and 2 pi turns more, from there on it is continuous
/// (mechanics/turns.hpp). Frames may part (the second axis is then projected, and the torque is the gradient of the
/// energy), as long as the projection is not shorter than 1/2.
struct TorsionSpring {
    static constexpr const char* type = "torsion_spring";
    int first = ground, second = 0;
    Mat3 axes_first = Mat3::Identity(), axes_second = Mat3::Identity();
    Real stiffness = 0, damping = 0, angle = 0;
    long turns = 0;  ///< full turns at the start

    // As mechanics/forces/forces.hpp asks of every force.
    template <class MotionOf, class AngleOf, class Push>
    void act(const Real& t, const MotionOf& motion, const AngleOf& theta, const Push& push) const;
    template <class MotionOf, class Push>
    void damp(const MotionOf& motion, const Push& push) const;
    bool is_damped() const { return damping != 0; }
    template <class MotionOf, class AngleOf>
    Real energy(const MotionOf& motion, const AngleOf& theta) const;
    bool is_conservative() const { return damping == 0; }
    bool is_internal() const { return !touches(ground); }
    bool touches(int body) const { return first == body || second == body; }
    bool may_push(int /*body*/) const { return false; }
    const Vec3* centre_on(int /*body*/) const { return nullptr; }
};

/// The angle of a torsion spring, from two poses and velocities.
struct Turn {
    Real principal;  ///< theta up to full turns, in (-pi, pi]
    Vec3 gradient;   ///< theta' = gradient . (omega_second - omega_first) in space axes
    Real rate;       ///< theta'
    Real shadow;     ///< length of the second frame's first axis, projected on the plane of the first: 1 on one axis
};
Turn turn(const TorsionSpring& spring, const Motion& first, const Motion& second);

/// At the angle theta, all turns counted.
WrenchPair exerted(const TorsionSpring& spring, const Turn& turn, const Real& theta, const Motion& first,
                   const Motion& second);
/// stiffness/2 (theta - angle)^2 (J).
Real stored_energy(const TorsionSpring& spring, const Real& theta);

template <class MotionOf, class AngleOf, class Push>
void TorsionSpring::act(const Real& /*t*/, const MotionOf& motion, const AngleOf& theta, const Push& push) const {
    const Motion one = motion(first), other = motion(second);
    const Turn now = turn(*this, one, other);
    push_pair(*this, exerted(*this, now, theta(now), one, other), push);
}

template <class MotionOf, class Push>
void TorsionSpring::damp(const MotionOf& motion, const Push& push) const {
    if (!is_damped()) return;
    TorsionSpring damper = *this;
    damper.stiffness = 0;
    const Motion one = motion(first), other = motion(second);
    push_pair(*this, exerted(damper, turn(*this, one, other), angle, one, other), push);
}

template <class MotionOf, class AngleOf>
Real TorsionSpring::energy(const MotionOf& /*motion*/, const AngleOf& theta) const {
    return stored_energy(*this, theta());
}

/// Those of a model.
struct TorsionSprings {
    std::vector<TorsionSpring> torsion_springs;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
