// SPDX-License-Identifier: BSD-3-Clause
//
// One-step check of symmetric projection.
#pragma once

#include "tests/judges/methods/checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The equations of the method; modified if a control requires it.
struct SymmetricProjectionForm {
    int gauss_stages = 1;       ///< 1: the midpoint rule
    bool after_alone = false;   ///< q~ = q, v~ = v
    bool start_alone = false;   ///< G(q) at both ends
    bool without_mass = false;  ///< C^T for M^{-1} C^T, as in the literature
};

/// methods/symmetric_projection/symmetric_projection.hpp [hairer2000].
Objection symmetric_projection_step_objection(const Method&, const SymmetricProjectionForm& form = {});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
