// SPDX-License-Identifier: BSD-3-Clause
//
// Velocities and accelerations of a formulation turned into space axes. What a body spinning fast about an axis of
// symmetry does is slow there, while in its own axes it turns with the body.
#pragma once

#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Offered by systems of bodies beside `System`.
class SpaceAxes {
  public:
    virtual ~SpaceAxes() = default;
    /// A vector of velocity coordinates (n), or of accelerations or changes of these, each part turned from the axes
    /// that the formulation has it in into those of space, for the pose q. `turned` may be the same storage.
    virtual void to_space_axes(const Real* q, const Real* v, Real* turned) const = 0;
    /// Back from there.
    virtual void from_space_axes(const Real* q, const Real* turned, Real* v) const = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
