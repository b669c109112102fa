// SPDX-License-Identifier: BSD-3-Clause
//
// Shared by the checks of running methods.
#pragma once

#include "tests/judges/methods/checks.hpp"
#include "tests/methods/stepping.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The first objection of `judge(model, formulation)` over all models and the formulations that apply.
template <class F>
Objection first_objection(const Method& entry, F judge) {
    for (const models::Named& named : models::for_methods())
        for (const std::string& formulation : models::applicable(named.model)) {
            if (!stepping::runs_on(entry, named.model, formulation)) continue;
            if (KREISEL_QUAD && named.model.bodies.size() != 1 && formulation != "SO3xR3") continue;  // slow
            const Objection objection = judge(named, formulation);
            if (!objection.empty()) return objection + " (" + named.name + " as " + formulation + ")";
        }
    return "";
}

inline Real largest(const std::vector<Real>& a) {
    Real size = 0;
    for (const Real& x : a) size = max(size, Real(abs(x)));
    return size;
}

inline Real largest_difference(const std::vector<Real>& a, const std::vector<Real>& b) {
    Real worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) worst = max(worst, Real(abs(a[i] - b[i])));
    return worst;
}

inline bool all_finite(const std::vector<Real>& a) {
    return std::all_of(a.begin(), a.end(), [](const Real& x) { return isfinite(x); });
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
