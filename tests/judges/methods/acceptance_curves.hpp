// SPDX-License-Identifier: BSD-3-Clause
//
// Errors on the acceptance problem, for methods that need not be registered.
#pragma once

#include "methods/contract/method.hpp"
#include "tests/support/order_rule.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using AcceptanceCurves = std::map<std::string, OrderCurve>;

/// Errors by metric of runs of 1 s on the forced heavy top as SO3xR3, with 64 to 1024 steps, or 4096 to 65536 for a
/// method of first order; empty if one of them fails.
AcceptanceCurves acceptance_curves(const Method& entry, bool first_order);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
