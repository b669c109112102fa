// SPDX-License-Identifier: BSD-3-Clause
//
// Rigid motions of a whole system that leave its gravity and its ties to the ground unchanged: each has a momentum that
// is constant (Noether). Ties between moving bodies do not restrict them.
#pragma once

#include <optional>
#include <vector>

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A line through P along the unit vector e.
struct Line {
    Vec3 P, e;
};

/// Whether all forces, gravity included, follow from a potential that does not depend on time.
bool is_conservative(const Model& model);
bool is_invariant_under_rotation(const Model& model, const Line& axis);
bool is_invariant_under_translation(const Model& model, const Vec3& e);

/// Where an axis of rotation must pass: the first ground point of a joint or force that fixes one; the origin if none
/// does.
Vec3 pivot(const Model& model);

/// What acts on one body beside gravity. Refers to the model.
struct BodyTies {
    std::vector<const Joint*> joints;
    std::vector<const Vec3*> centres;  ///< of each force what its centre_on (mechanics/forces/forces.hpp) says
    bool none() const { return joints.empty() && centres.empty(); }
};
/// Those of each body of a model, found in one pass over its joints and its forces.
std::vector<BodyTies> ties_of_bodies(const Model& model);

/// Unit axis about which a body of this number, held by these ties, is symmetric, through which all forces on it act,
/// so that its angular momentum along it is constant; nothing for a point mass.
std::optional<Vec3> free_spin_axis(const Body& body, int number, const BodyTies& ties);

/// Kovalevskaya's case of a heavy top, A = B = 2 C about the fixed point with the mass centre in the plane of A and B:
/// the axes e_1 (to the mass centre), e_2, e_3 (of C) as columns, in body axes, and c = m g l/C (1/s^2)
/// [audin1996, Sec. I.2]; nothing if the body is not such a top.
struct KovalevskayaTop {
    Mat3 axes;
    Real c;
    Vec3 up;
};
std::optional<KovalevskayaTop> kovalevskaya_top(const Body& body, int number, const BodyTies& ties,
                                                const Gravity& gravity);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
