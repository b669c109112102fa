// SPDX-License-Identifier: BSD-3-Clause
//
// Queries of the order suites on the registry and on residuals.
#pragma once

#include <vector>

#include "methods/contract/method.hpp"
#include "tests/judges/conditions/numeric_tableau.hpp"

namespace kreisel::orders {

/// Registered methods that declare a scheme of this kind.
inline std::vector<const Method*> registered(Scheme::Kind kind) {
    std::vector<const Method*> found;
    for (const Method& method : methods())
        if (method.factory.scheme && method.factory.scheme->kind == kind) found.push_back(&method);
    return found;
}

/// Calls f(tableau with one coefficient larger by 1e-6, number of the coefficient) for each coefficient.
template <class F>
void each_changed(NumericTableau<Rational> tableau, F f) {
    int number = 0;
    each_coefficient(tableau, [&](Rational& coefficient) {
        const Rational declared = coefficient;
        coefficient += Rational(1, 1000000);
        f(tableau, number++);
        coefficient = declared;
    });
}

}  // namespace kreisel::orders
