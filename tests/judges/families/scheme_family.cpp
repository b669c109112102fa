// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/families/scheme_family.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

ClassicalScheme classical_scheme(const Tableau& tableau) {
    const auto numbers = [](const std::vector<Coefficient>& row) {
        std::vector<Real> values;
        for (const auto& entry : row) values.push_back(value(entry));
        return values;
    };
    ClassicalScheme scheme;
    for (const auto& row : tableau.a) scheme.a.push_back(numbers(row));
    scheme.b = numbers(tableau.b);
    return scheme;
}

Real magnitude(const ClassicalScheme& scheme) {
    Real largest = 1;
    const auto see = [&](const std::vector<Real>& row) {
        Real sum = 0;
        for (const Real& entry : row) sum += abs(entry);
        largest = max(largest, sum);
    };
    for (const auto& row : scheme.a) see(row);
    see(scheme.b);
    return largest;
}

const SchemeFamily* family_of(const Scheme& scheme) {
    for (const SchemeFamily& family : Registered<SchemeFamily>::all())
        if (family.knows(scheme)) return &family;
    return nullptr;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
