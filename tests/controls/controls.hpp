// SPDX-License-Identifier: BSD-3-Clause
//
// Methods and projections broken on purpose, with faults found in public codes: every method keeps its
// state on the group to round-off and converges. They are not registered; the checks of checks.hpp must reject
// them.
#pragma once

#include <algorithm>
#include <vector>

#include "tests/judges/methods/checks.hpp"
#include "tests/support/order_rule.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A broken method: its description and scheme are those it claims, its steps differ.
struct Control {
    Method method;
    /// Order on a non-commuting, state- and time-dependent field; if this is less
    /// than the declared order, the check of observed orders must reject it.
    int true_order;
    /// The checks that must reject it, besides the observed order; others may.
    std::vector<Check> caught_by;

    bool seen_by_order() const {
        return true_order < method.description.order.configuration &&
               (KREISEL_QUAD || is_seen_in_double(method.description));
    }
    /// Whether only a property that it claims is wrong: its order is that of a sound method, or shows only on bodies
    /// that no force of the acceptance problem acts on.
    bool claims_too_much() const {
        return std::all_of(caught_by.begin(), caught_by.end(), [](Check check) {
            return check == Check::symplecticity || check == Check::momentum || check == Check::energy ||
                   check == Check::bounded_energy || check == Check::constraints;
        });
    }
    bool must_be_caught_by(Check check) const {
        if (check == Check::order) return seen_by_order();
        if (check == Check::bounded_energy && KREISEL_QUAD) return false;  // long runs are made in double
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
