// SPDX-License-Identifier: BSD-3-Clause
//
// What RATTLie and SHAKELie share as methods: the option of their coordinates, and the systems that they decline.
#pragma once

#include <functional>
#include <memory>

#include "methods/contract/integrator.hpp"
#include "methods/variational/rattle_equations.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using MakeRattle = std::function<std::unique_ptr<Integrator>(System&, std::unique_ptr<RattleEquations>)>;

/// `make` gets the equations in the coordinates of the option.
Factory rattle_family(MakeRattle make);

/// RATTLie of these equations.
std::unique_ptr<Integrator> make_rattlie(System& system, std::unique_ptr<RattleEquations> equations);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
