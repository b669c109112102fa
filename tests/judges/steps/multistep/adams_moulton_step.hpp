// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/judges/methods/checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// How slopes may be taken; anything but the defaults is wrong.
struct AdamsMoultonForm {
    bool recentred = true;  ///< pulled back into the chart around the newest state
    int sign_of_sigma = 1;
    int differences_left_out = 0;  ///< of the highest orders
};

/// The steps of `method` are those of the Adams-Moulton method with k steps, after k - 1 of rkmk/verner6 backwards.
Objection adams_moulton_step_objection(const Method& method, int k, const AdamsMoultonForm& form = {});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
