// SPDX-License-Identifier: BSD-3-Clause
//
// Springs between two points whose tension is a polynomial in the stretch.
#pragma once

#include <vector>

#include "mechanics/forces/point_line.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Along the line of two points, of length l: tension sum_i coefficients_i s^i + damping l' with the stretch
/// s = l - length and i = 1, 2, ... (N/m, N/m^2, ...). The points may not meet.
struct PolynomialSpring {
    static constexpr const char* type = "polynomial_spring";
    int first = ground, second = 0;
    Vec3 r_first = Vec3::Zero(), r_second = Vec3::Zero();
    std::vector<Real> coefficients;
    Real damping = 0, length = 0;

    // As mechanics/forces/forces.hpp asks of every force.
    template <class MotionOf, class AngleOf, class Push>
    void act(const Real& /*t*/, const MotionOf& motion, const AngleOf& /*angle*/, const Push& push) const {
        pull(motion, push, [&](const PointLine& line) -> Real {
            return elastic_tension(line.length - length) + damping * line.rate;
        });
    }
    template <class MotionOf, class Push>
    void damp(const MotionOf& motion, const Push& push) const {
        if (!is_damped()) return;
        pull(motion, push, [&](const PointLine& line) -> Real { return damping * line.rate; });
    }
    bool is_damped() const { return damping != 0; }
    template <class MotionOf, class AngleOf>
    Real energy(const MotionOf& motion, const AngleOf& /*angle*/) const {
        return potential(point_line(*this, motion(first), motion(second)).length - length);
    }
    bool is_conservative() const { return damping == 0; }
    bool is_internal() const { return !touches(ground); }
    bool touches(int body) const { return first == body || second == body; }
    bool may_push(int body) const { return touches(body); }
    const Vec3* centre_on(int body) const { return first == body ? &r_first : &r_second; }

    /// sum_i coefficients_i s^i (N).
    Real elastic_tension(const Real& s) const;
    /// sum_i coefficients_i s^{i+1} / (i + 1) (J).
    Real potential(const Real& s) const;

  private:
    template <class MotionOf, class Push, class Tension>
    void pull(const MotionOf& motion, const Push& push, const Tension& tension) const {
        const Motion one = motion(first), other = motion(second);
        const PointLine line = point_line(*this, one, other);
        push_pair(*this, pulled(*this, one, other, line, tension(line)), push);
    }
};

/// Those of a model.
struct PolynomialSprings {
    std::vector<PolynomialSpring> polynomial_springs;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
