// SPDX-License-Identifier: BSD-3-Clause
//
// Methods that are broken on purpose, as public codes have been found broken: every one keeps its state on the group to
// round-off and converges. They are not registered; the suites that judge methods must turn them down.
#pragma once

#include <vector>

#include "methods/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A broken method: its description and scheme are what it claims to be, its steps are something else.
struct Control {
    Method method;
    /// Order that it has on a field that does not commute, depends on the state and depends on time; where this is less
    /// than the declared order, a judgement of observed orders must turn it down.
    int true_order;
    /// A judgement by one step with scripted slopes must turn it down.
    bool seen_by_one_step;

    bool seen_by_order() const { return true_order < method.description.order.configuration; }
};

/// All controls, by names "control/<method>_<fault>".
const std::vector<Control>& controls();

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
