// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/judges/methods/checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// What a control has otherwise.
struct HalfExplicitForm {
    bool first_solved = false;     ///< the velocity of the second stage is constrained too [braseyhairer1993]
    bool without_dexpinv = false;  ///< k_i = V_i
};

/// methods/half_explicit/herk3.cpp, three steps.
Objection herk3_step_objection(const Method&, const HalfExplicitForm& form = {});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
