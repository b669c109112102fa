// SPDX-License-Identifier: BSD-3-Clause
//
// The same mechanism in other units: lengths, masses and times multiplied by powers of two, and all else with them.
#pragma once

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace models {

struct Units {
    int length = 0, mass = 0, time = 0;  ///< exponents of two
    Real L() const { return ldexp(Real(1), length); }
    Real M() const { return ldexp(Real(1), mass); }
    Real T() const { return ldexp(Real(1), time); }
    Real speed() const { return L() / T(); }
    Real acceleration() const { return speed() / T(); }
    Real force() const { return M() * acceleration(); }
    Real torque() const { return force() * L(); }
};

inline BodyState scaled(const BodyState& s, const Units& u) {
    return {s.x * u.L(), s.R, s.v * u.speed(), s.omega / u.T()};
}

/// A prescribed coordinate, its values times `unit` and the time in which it has them times `time`.
inline Prescribed scaled(Prescribed law, const Real& unit, const Real& time) {
    Real power = unit;
    for (Real& c : law.polynomial) c *= power, power /= time;
    for (Sinusoid& one : law.sinusoids) one.amplitude *= unit, one.frequency /= time;
    return law;
}

inline Model scaled(Model model, const Units& u) {
    for (Body& body : model.bodies) {
        body.start = scaled(body.start, u);
        body.mass *= u.M();
        if (!body.point) body.J *= u.M() * u.L() * u.L();
    }
    for (Joint& joint : model.joints) {
        joint.r_first *= u.L(), joint.r_second *= u.L(), joint.length *= u.L(), joint.frequency /= u.T();
        joint.turn = scaled(joint.turn, 1, u.T()), joint.shift = scaled(joint.shift, u.L(), u.T());
        joint.lead *= u.L();
    }
    model.gravity.g *= u.acceleration(), model.gravity.frequency /= u.T();
    for (Load& load : model.loads)
        load.force *= u.force(), load.torque *= u.torque(), load.point *= u.L(), load.frequency /= u.T();
    for (Spring& s : model.springs) {
        s.r_first *= u.L(), s.r_second *= u.L(), s.length *= u.L();
        s.stiffness *= u.force() / u.L(), s.damping *= u.force() / u.speed();
    }
    for (TorsionSpring& s : model.torsion_springs) s.stiffness *= u.torque(), s.damping *= u.torque() * u.T();
    for (PolynomialSpring& s : model.polynomial_springs) {
        s.r_first *= u.L(), s.r_second *= u.L(), s.length *= u.L();
        Real unit = u.force();
        for (Real& coefficient : s.coefficients) coefficient *= unit /= u.L();
        s.damping *= u.force() / u.speed();
    }
    for (Damper& d : model.dampers) d.r_second *= u.L(), d.damping *= u.force() / u.speed();
    for (RotationalDamper& d : model.rotational_dampers) d.damping *= u.torque() * u.T();
    for (Attraction& a : model.attractions)
        a.r_first *= u.L(), a.r_second *= u.L(), a.strength *= u.force() * u.L() * u.L();
    for (Bushing& b : model.bushings) {
        b.r_first *= u.L(), b.r_second *= u.L();
        b.stiffness[0] *= u.force() / u.L(), b.stiffness[1] *= u.torque();
        b.damping[0] *= u.force() / u.speed(), b.damping[1] *= u.torque() * u.T();
    }
    return model;
}

/// All of one kind by each power, and mixtures.
inline std::vector<Units> other_units() {
    std::vector<Units> all;
    for (const int k : {-20, -7, 3, 20}) {
        all.push_back({.length = k}), all.push_back({.mass = k}), all.push_back({.time = k});
        all.push_back({.length = k, .mass = -7, .time = 5});
    }
    return all;
}

}  // namespace models
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
