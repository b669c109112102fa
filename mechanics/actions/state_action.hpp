// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lie/group.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A group by whose exponentials states move, y' = y z, where it is another than TG, in which velocities are additive:
/// a group structure on states, stored as (q, v), with an algebra of the size of that of TG.
class StateAction : public Group {
  public:
    using Group::Group;
    /// z in the algebra of TG becomes the element of this algebra with the same y', in place; and back.
    virtual void from_tangent(const Real* y, Real* z) const = 0;
    virtual void to_tangent(const Real* y, Real* z) const = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
