// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "methods/contract/integrator.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The method, which tells the system where its steps begin and end, so that torsion springs count full turns
/// (mechanics/turns.hpp); itself where there are none, and the system is no StepWatcher.
std::unique_ptr<Integrator> counting_turns(System& system, std::unique_ptr<Integrator> method);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
