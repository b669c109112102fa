// SPDX-License-Identifier: BSD-3-Clause
//
// What certifies the schemes of a family, evaluated from their data and nothing else. Each family registers it in a
// file of its own beside this one; its methods then need no line here.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "methods/contract/scheme.hpp"
#include "support/registered.hpp"
#include "support/registration.hpp"
#include "tests/judges/families/dense_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The largest p such that the order conditions up to p hold, of the solution, in a pair of the embedded one, and of
/// dense output.
struct SchemeOrders {
    int step = 0, embedded = 0, dense = 0;
};

/// What is left of a scheme on R^n: an explicit Runge-Kutta method, zeros left out at the end of rows.
struct ClassicalScheme {
    std::vector<std::vector<Real>> a;
    std::vector<Real> b;
};
ClassicalScheme classical_scheme(const Tableau& tableau);
/// The largest of 1 and the sums of |a_ij| and |b_j|: by what round-off, and the size of scripted stages, can grow.
Real magnitude(const ClassicalScheme& scheme);

struct SchemeFamily {
    std::string name;
    std::function<bool(const Scheme&)> knows;
    std::function<DenseStep(const Scheme&, const ScriptedStep&)> step;
    std::function<SchemeOrders(const Scheme&)> orders;
    std::function<ClassicalScheme(const Scheme&)> classical;
};

/// Null for a scheme that no file beside this one knows.
const SchemeFamily* family_of(const Scheme& scheme);

/// A static object of this type registers the family with this type of data.
struct FamilyRegistration {
    template <class Data>
    FamilyRegistration(const char* name, DenseStep (*step)(const Data&, const ScriptedStep&),
                       SchemeOrders (*orders)(const Data&), ClassicalScheme (*classical)(const Data&)) {
        Registered<SchemeFamily>::add(
            {name, [](const Scheme& scheme) { return scheme.as<Data>() != nullptr; },
             [step](const Scheme& scheme, const ScriptedStep& given) { return step(*scheme.as<Data>(), given); },
             [orders](const Scheme& scheme) { return orders(*scheme.as<Data>()); },
             [classical](const Scheme& scheme) { return classical(*scheme.as<Data>()); }});
    }
};

/// KREISEL_SCHEME_FAMILY("name", step, orders, classical): functions of the family's data.
#define KREISEL_SCHEME_FAMILY(...) KREISEL_REGISTER(::kreisel::FamilyRegistration, __VA_ARGS__)

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
