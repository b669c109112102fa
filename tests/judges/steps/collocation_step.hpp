// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/judges/methods/checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

enum class CollocationPoints { gauss, radau, lobatto };

/// A tableau of implicit stages; modified if a control requires it.
struct CollocationForm {
    CollocationPoints points;
    int stages;                            ///< 2 or 3, of Lobatto points to 4
    bool around_middle;                    ///< coordinates around the middle of the step, else around q
    bool velocities_by_companion = false;  ///< IIIB beside IIIA
};
inline constexpr CollocationForm gauss_form(int stages) { return {CollocationPoints::gauss, stages, true}; }
inline constexpr CollocationForm radau_form(int stages) { return {CollocationPoints::radau, stages, false}; }
inline constexpr CollocationForm lobatto_form(int stages) { return {CollocationPoints::lobatto, stages, true, true}; }

/// A step of methods/rkmk/implicit_rkmk.hpp with these coefficients.
Objection collocation_step_objection(const Method& method, const CollocationForm& form);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
