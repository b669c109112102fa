// SPDX-License-Identifier: BSD-3-Clause
//
// Systems whose states move in a group of their own in place of TG.
#pragma once

#include "mechanics/actions/state_action.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Offered by systems beside `System`.
class ActedUpon {
  public:
    virtual ~ActedUpon() = default;
    /// Null where it is TG.
    virtual const StateAction* action() const = 0;
};

/// Null where states move in TG.
inline const StateAction* action_on(const System& system) {
    const auto* acted_upon = dynamic_cast<const ActedUpon*>(&system);
    return acted_upon ? acted_upon->action() : nullptr;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
