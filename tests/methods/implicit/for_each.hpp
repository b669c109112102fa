// SPDX-License-Identifier: BSD-3-Clause
//
// The registered methods that a test of implicit steps is about.
#pragma once

#include "tests/methods/linkages.hpp"

namespace stepping {

/// Those that meet the constraints.
template <class F>
void for_each_on_constraints(F f) {
    for (const Method& entry : methods())
        if (entry.description.meets_constraints()) {
            INFO(entry.description.name);
            f(entry);
        }
}

/// The implicit ones in steps of a given size that take redundant rows.
template <class F>
void for_each_implicit(F f) {
    for (const Method& entry : methods())
        if (entry.description.is_implicit() && runs_on(entry, linkages::planar_four_bar(), "SO3xR3")) {
            INFO(entry.description.name);
            f(entry);
        }
}

}  // namespace stepping
