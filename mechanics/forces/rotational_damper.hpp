// SPDX-License-Identifier: BSD-3-Clause
//
// Dampers that resist the turning of one body against another about every axis.
#pragma once

#include <vector>

#include "mechanics/forces/wrench.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Torque -damping (omega_second - omega_first) on the second body and its opposite on the first (damping in
/// N m s/rad).
struct RotationalDamper {
    static constexpr const char* type = "rotational_damper";
    int first = ground, second = 0;
    Real damping = 0;

    // As mechanics/forces/forces.hpp asks of every force.
    template <class MotionOf, class AngleOf, class Push>
    void act(const Real& /*t*/, const MotionOf& motion, const AngleOf& /*angle*/, const Push& push) const {
        damp(motion, push);
    }
    template <class MotionOf, class Push>
    void damp(const MotionOf& motion, const Push& push) const {
        push_pair(*this, exerted(motion(first), motion(second)), push);
    }
    bool is_damped() const { return damping != 0; }
    template <class MotionOf, class AngleOf>
    Real energy(const MotionOf& /*motion*/, const AngleOf& /*angle*/) const {
        return 0;
    }
    bool is_conservative() const { return damping == 0; }
    bool is_internal() const { return !touches(ground); }
    bool touches(int body) const { return first == body || second == body; }
    bool may_push(int /*body*/) const { return false; }
    const Vec3* centre_on(int /*body*/) const { return nullptr; }

    WrenchPair exerted(const Motion& one, const Motion& other) const;
};

/// Those of a model.
struct RotationalDampers {
    std::vector<RotationalDamper> rotational_dampers;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
