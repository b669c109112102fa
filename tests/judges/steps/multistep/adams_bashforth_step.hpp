// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/judges/steps/recorded_steps.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// How slopes of earlier states may be taken; anything but the defaults is wrong.
struct AdamsForm {
    bool recentred = true;  ///< pulled back into the chart around the newest state
    int sign_of_sigma = 1;
    int differences_left_out = 0;  ///< of the highest orders
};

/// The steps of `method` are those of the Adams-Bashforth method with k steps, the first k - 1 those of rkmk/rk4.
Objection adams_bashforth_step_objection(const Method& method, int k, const AdamsForm& form = {});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
