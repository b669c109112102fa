// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "tests/judges/families/scheme_family.hpp"
#include "tests/judges/steps/scheme_checks.hpp"
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::string of(int found, int declared) { return std::to_string(found) + " of " + std::to_string(declared); }

/// The difference of two solutions of the orders p and p^ is O(h^(min(p, p^) + 1)).
Objection estimate_objection(const SchemeOrders& found, int declared) {
    if (declared == 0)
        return found.embedded == 0 ? "" : "has an embedded solution, and declares no estimate of its error";
    if (found.embedded == 0) return "declares an estimate of its error, which its scheme does not have";
    const int estimate = std::min(found.step, found.embedded) + 1;
    return estimate == declared ? "" : "estimate of the error of order " + of(estimate, declared);
}

Objection without_scheme(const Method& method) {
    if (method.description.is_implicit()) return "";
    const StepCheck* check = step_check_of(method);
    if (check && !check->without_conditions.empty()) return "";
    return "no order conditions for an explicit method without a scheme: declare it, or state why it has none";
}

}  // namespace

Objection order_conditions_objection(const Method& method) {
    if (!method.factory.scheme) return without_scheme(method);
    const SchemeFamily* family = family_of(*method.factory.scheme);
    if (!family) return "no file of tests/judges/families knows the family of its scheme";
    const SchemeOrders found = family->orders(*method.factory.scheme);
    const int declared = method.description.order.configuration;
    if (found.step != declared) return "order " + of(found.step, declared);
    if (found.dense != method.description.dense)
        return "dense output of order " + of(found.dense, method.description.dense);
    return estimate_objection(found, method.description.estimate);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
