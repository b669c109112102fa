// SPDX-License-Identifier: BSD-3-Clause
//
// Methods and projections that are broken on purpose, as public codes have been found broken: every method keeps its
// state on the group to round-off and converges. They are not registered; the judgements of checks.hpp must turn them
// down.
#pragma once

#include <algorithm>
#include <vector>

#include "tests/judges/methods/checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A broken method: its description and scheme are what it claims to be, its steps are something else.
struct Control {
    Method method;
    /// Order that it has on a field that does not commute, depends on the state and depends on time; where this is less
    /// than the declared order, a judgement of observed orders must turn it down.
    int true_order;
    /// What must turn it down, besides the observed order; others may.
    std::vector<Check> caught_by;

    bool seen_by_order() const { return true_order < method.description.order.configuration; }
    bool must_be_caught_by(Check check) const {
        if (check == Check::order) return seen_by_order();
        return std::find(caught_by.begin(), caught_by.end(), check) != caught_by.end();
    }
};

/// All controls, by names "control/<method>_<fault>".
const std::vector<Control>& controls();
struct ProjectionControl {
    ProjectionMethod method;
    Check caught_by;
};
const std::vector<ProjectionControl>& projection_controls();

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
