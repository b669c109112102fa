// SPDX-License-Identifier: BSD-3-Clause
#include "tests/orders/crouch_grossman_conditions.hpp"
#include "tests/orders/rooted_trees.hpp"
#include "tests/orders/scheme_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

Objection order_conditions_objection(const Method& method) {
    if (!method.factory.scheme) return "";
    const auto& [kind, tableau] = *method.factory.scheme;
    const auto coefficients = orders::exact(tableau);
    const auto slack = orders::rounding(tableau);
    const int found = kind == Scheme::Kind::munthe_kaas ? orders::butcher_order(coefficients, slack)
                                                        : orders::crouch_grossman_order(coefficients, slack);
    const int declared = method.description.order.configuration;
    return found == declared ? "" : "order " + std::to_string(found) + " of " + std::to_string(declared);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
