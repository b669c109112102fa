// SPDX-License-Identifier: BSD-3-Clause
//
// What a user writes for a force, a file each in mechanics/parts/forces/. Plain data, compiled once for all precisions.
// Its law, and how it is made of the values, is in mechanics/forces/.
#pragma once

#include <string>
#include <vector>

#include "mechanics/parts/keys.hpp"
#include "support/registration.hpp"

namespace kreisel {

struct ForceTraits {
    int place = 100;          ///< in lists; forces of one place come by name
    bool rigid_only = false;  ///< it exerts torques, so that a point mass is refused
};

struct ForceKind : ElementType, ForceTraits {};

/// All forces, in the order of their places.
const std::vector<ForceKind>& force_kinds();
/// Throws std::out_of_range for an unknown name.
const ForceKind& force_kind(const std::string& name);

struct ForceRegistration {
    explicit ForceRegistration(ElementType keys, ForceTraits traits = {});
};

/// KREISEL_FORCE_KEYS({keys}, {traits}) in its file.
#define KREISEL_FORCE_KEYS(...) KREISEL_REGISTER(::kreisel::ForceRegistration, __VA_ARGS__)

}  // namespace kreisel
