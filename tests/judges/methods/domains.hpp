// SPDX-License-Identifier: BSD-3-Clause
//
// The classes of systems on which methods claim properties (methods/contract/claims.hpp).
#pragma once

#include <optional>

#include "mechanics/forces/forces.hpp"
#include "tests/judges/methods/runs.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The smallest class that a system is of; what depends on time counts as the largest.
inline Domain domain_of(const Model& model, const System& system) {
    const bool holonomic = system.position_constraints() == system.constraints();
    if (system.is_dissipative() || !system.has_potential() || !holonomic) return Domain::autonomous;
    if (system.constraints() > 0) return Domain::constrained;
    return model.gravity.g.isZero(0) && !has_forces(model) ? Domain::free : Domain::potential;
}

/// The largest class on which a method claims a property; nothing where it does not claim it.
inline std::optional<Domain> claimed_domain(const MethodDescription& method, Property property) {
    std::optional<Domain> largest;
    for (const Claim& claim : method.preserves)
        if (claim.property == property && (!largest || *largest < claim.domain)) largest = claim.domain;
    return largest;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
