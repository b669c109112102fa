// SPDX-License-Identifier: BSD-3-Clause
//
// What a method preserves, as it declares: each property on a class of systems.
#pragma once

namespace kreisel {

enum class Property {
    symplectic,   ///< the step map preserves the canonical two-form of T*G
    symmetric,    ///< a step by -h undoes a step by h
    momentum,     ///< the momentum maps of symmetries that act by rigid motions of space
    energy,       ///< the total energy
    constraints,  ///< positions and velocities of the constraints, both without a projection
};

/// Classes of systems, each part of the next.
enum class Domain {
    free,         ///< no force, no joint
    potential,    ///< forces of a potential, no joint
    constrained,  ///< forces of a potential, holonomic joints
    autonomous,   ///< whatever does not depend on time: dissipation, rolling
};

struct Claim {
    Property property;
    Domain domain;
    bool operator==(const Claim&) const = default;
};

constexpr const char* name(Property property) {
    switch (property) {
        case Property::symplectic:
            return "symplectic";
        case Property::symmetric:
            return "symmetric";
        case Property::momentum:
            return "momentum-preserving";
        case Property::energy:
            return "energy-preserving";
        case Property::constraints:
            return "constraint-preserving";
    }
    return "";
}

constexpr const char* name(Domain domain) {
    switch (domain) {
        case Domain::free:
            return "free";
        case Domain::potential:
            return "potential";
        case Domain::constrained:
            return "constrained";
        case Domain::autonomous:
            return "autonomous";
    }
    return "";
}

}  // namespace kreisel
