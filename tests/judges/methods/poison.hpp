// SPDX-License-Identifier: BSD-3-Clause
//
// What is injected, and into which quantity of a model.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

inline std::vector<Real> poisons() {
    const Real infinite = std::numeric_limits<Real>::infinity();
    return {std::numeric_limits<Real>::quiet_NaN(), infinite, -infinite};
}

/// A quantity of a model that can be spoiled.
struct Target {
    const char* name;
    std::function<Real&(Model&)> in;
};

/// The lever enters Phi, C and the bias, and on SO3 the inertia about the pivot. (An anchor on the ground enters Phi
/// only, which only methods with multipliers read: tests/methods/implicit.cpp spoils Phi.)
inline std::vector<Target> targets() {
    return {{"force", [](Model& model) -> Real& { return model.gravity.g[2]; }},
            {"mass", [](Model& model) -> Real& { return model.bodies.back().mass; }},
            {"inertia", [](Model& model) -> Real& { return model.bodies.back().J(1, 1); }},
            {"joint", [](Model& model) -> Real& { return model.joints.back().r_second[1]; }}};
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
