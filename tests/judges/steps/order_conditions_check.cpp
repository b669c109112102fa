// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/conditions/crouch_grossman_conditions.hpp"
#include "tests/judges/conditions/tableau_orders.hpp"
#include "tests/judges/steps/scheme_checks.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Explicit methods, or families, whose order has no conditions to check here.
struct Exemption {
    std::string of, reason;
};
const std::vector<Exemption> exemptions = {{"baseline/",
                                            "the tableau is in Boost.Odeint; steps are compared with the classical "
                                            "method, tests/judges/steps/baseline_step.cpp"}};

Objection without_scheme(const Method& method) {
    if (method.description.implicit) return "";
    for (const Exemption& exemption : exemptions)
        if (covers(exemption.of, method.description.name) && !exemption.reason.empty()) return "";
    return "no order conditions for an explicit method without a scheme: declare it, or state why it has none";
}

}  // namespace

Objection order_conditions_objection(const Method& method) {
    if (!method.factory.scheme) return without_scheme(method);
    const auto& [kind, tableau] = *method.factory.scheme;
    const int declared = method.description.order.configuration;
    if (kind == Scheme::Kind::munthe_kaas)
        return orders::tableau_objection(tableau, declared, method.description.estimate);
    const int found = orders::crouch_grossman_order(orders::exact(tableau), orders::rounding(tableau));
    return found == declared ? "" : "order " + std::to_string(found) + " of " + std::to_string(declared);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
