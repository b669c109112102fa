// SPDX-License-Identifier: BSD-3-Clause
//
// Conversion between Real and the text in which numbers leave and enter the engine.
#pragma once

#include <array>
#include <vector>

#include "engine/engine.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

Number to_number(const Real& x);
std::array<Number, 3> to_numbers(const Vec3& v);
ConstraintSummary to_summary(const ConstraintRank& rank);
Real from_number(const Number& x);

ReportedState to_report(const Real& t, const std::vector<BodyState>& states, const Model& model,
                        const std::vector<Real>& multipliers, const std::vector<SpringAngle>& springs);
/// "ground-wheel" of a spring between ground and wheel; where several are between the same bodies, "ground-wheel-2" of
/// the second, and so on.
std::vector<std::string> names_of_torsion_springs(const Model& model);
std::vector<BodyState> from_report(const ReportedState& report);

/// The distances behind error.*: Euclidean norms over all bodies of x, v, omega (m, m/s, rad/s), and of log(R_b^T R_a)
/// (rad). Where an R is off SO(3) by more than 1/10 it has no angle, and rotation is NaN (not measured).
struct Distance {
    Real position = 0, rotation = 0, velocity = 0, omega = 0;
};
Distance distance(const std::vector<BodyState>& a, const std::vector<BodyState>& b);
/// Part by part; NaN where one of them is.
Distance largest(const Distance& a, const Distance& b);

/// |a - b| of two vectors of equal size.
Real norm_of_difference(const std::vector<Real>& a, const std::vector<Real>& b);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
