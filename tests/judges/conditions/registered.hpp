// SPDX-License-Identifier: BSD-3-Clause
//
// Queries of the order suites on the registry and on residuals.
#pragma once

#include <vector>

#include "methods/conditions/numeric_tableau.hpp"
#include "methods/contract/method.hpp"

namespace kreisel::orders {

/// The data that a method declares as a scheme of this family; null for a method of another.
template <class Family>
const Family* scheme_of(const Method& method) {
    return method.factory.scheme ? method.factory.scheme->as<Family>() : nullptr;
}

/// Registered methods that declare a scheme of this family.
template <class Family>
std::vector<const Method*> registered() {
    std::vector<const Method*> found;
    for (const Method& method : methods())
        if (scheme_of<Family>(method)) found.push_back(&method);
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
