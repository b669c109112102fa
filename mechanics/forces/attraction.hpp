// SPDX-License-Identifier: BSD-3-Clause
//
// Newton's attraction between two points: of bodies, or of a body and a centre in space.
#pragma once

#include <vector>

#include "mechanics/forces/point_line.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Along the line of two points, of length l: both are pulled together by strength / l^2. Between mass centres of m_1
/// and m_2 the strength is G m_1 m_2, for a body in a central field mu m (N m^2). The points may not meet.
struct Attraction {
    static constexpr const char* type = "attraction";
    int first = ground, second = 0;
    Vec3 r_first = Vec3::Zero(), r_second = Vec3::Zero();
    Real strength = 0;

    // As mechanics/forces/forces.hpp asks of every force.
    template <class MotionOf, class AngleOf, class Push>
    void act(const Real& /*t*/, const MotionOf& motion, const AngleOf& /*angle*/, const Push& push) const {
        const Motion one = motion(first), other = motion(second);
        const PointLine line = point_line(*this, one, other);
        push_pair(*this, pulled(*this, one, other, line, strength / (line.length * line.length)), push);
    }
    template <class MotionOf, class Push>
    void damp(const MotionOf& /*motion*/, const Push& /*push*/) const {}
    bool is_damped() const { return false; }
    /// -strength / l (J): 0 at infinity.
    template <class MotionOf, class AngleOf>
    Real energy(const MotionOf& motion, const AngleOf& /*angle*/) const {
        return -strength / point_line(*this, motion(first), motion(second)).length;
    }
    bool is_conservative() const { return true; }
    bool is_internal() const { return !touches(ground); }
    bool touches(int body) const { return first == body || second == body; }
    bool may_push(int body) const { return touches(body); }
    const Vec3* centre_on(int body) const { return first == body ? &r_first : &r_second; }
};

/// Those of a model.
struct Attractions {
    std::vector<Attraction> attractions;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
