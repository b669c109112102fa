// SPDX-License-Identifier: BSD-3-Clause
//
// Springs and dampers between two points.
#pragma once

#include <vector>

#include "mechanics/forces/wrench.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Along the line of two points, of length l: tension stiffness (l - length) + damping l'. With length = 0 the points
/// may meet, unless there is damping.
struct Spring {
    static constexpr const char* type = "spring";
    int first = ground, second = 0;
    Vec3 r_first = Vec3::Zero(), r_second = Vec3::Zero();
    Real stiffness = 0, damping = 0, length = 0;

    // As mechanics/forces/forces.hpp asks of every force.
    template <class MotionOf, class AngleOf, class Push>
    void act(const Real& t, const MotionOf& motion, const AngleOf& angle, const Push& push) const;
    template <class MotionOf, class Push>
    void damp(const MotionOf& motion, const Push& push) const;
    bool is_damped() const { return damping != 0; }
    template <class MotionOf, class AngleOf>
    Real energy(const MotionOf& motion, const AngleOf& angle) const;
    bool is_conservative() const { return damping == 0; }
    bool is_internal() const { return !touches(ground); }
    bool touches(int body) const { return first == body || second == body; }
    bool may_push(int body) const { return touches(body); }
    const Vec3* centre_on(int body) const { return first == body ? &r_first : &r_second; }
};

WrenchPair exerted(const Spring& spring, const Motion& first, const Motion& second);
/// stiffness/2 (l - length)^2 (J).
Real stored_energy(const Spring& spring, const Motion& first, const Motion& second);

template <class MotionOf, class AngleOf, class Push>
void Spring::act(const Real& /*t*/, const MotionOf& motion, const AngleOf& /*angle*/, const Push& push) const {
    push_pair(*this, exerted(*this, motion(first), motion(second)), push);
}

template <class MotionOf, class Push>
void Spring::damp(const MotionOf& motion, const Push& push) const {
    if (!is_damped()) return;
    Spring damper = *this;
    damper.stiffness = 0;
    push_pair(*this, exerted(damper, motion(first), motion(second)), push);
}

template <class MotionOf, class AngleOf>
Real Spring::energy(const MotionOf& motion, const AngleOf& /*angle*/) const {
    return stored_energy(*this, motion(first), motion(second));
}

/// Those of a model.
struct Springs {
    std::vector<Spring> springs;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
