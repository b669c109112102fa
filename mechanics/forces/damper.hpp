// SPDX-License-Identifier: BSD-3-Clause
//
// Dampers that resist the motion of one body past another in every direction.
#pragma once

#include <vector>

#include "mechanics/forces/wrench.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// At the point P that r_second is of the second body: force -damping (v_second(P) - v_first(P)) on the second body and
/// its opposite on the first, where v(P) is the velocity of the point of each body that is at P (damping in N s/m).
struct Damper {
    static constexpr const char* type = "damper";
    int first = ground, second = 0;
    Vec3 r_second = Vec3::Zero();
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
    bool may_push(int body) const { return touches(body); }
    /// P moves in the first body.
    const Vec3* centre_on(int body) const { return second == body ? &r_second : nullptr; }

    WrenchPair exerted(const Motion& one, const Motion& other) const;
};

/// Those of a model.
struct Dampers {
    std::vector<Damper> dampers;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
