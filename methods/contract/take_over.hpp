// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <vector>

#include "lie/real.hpp"
#include "lie/status.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// y <- next, if all of next is finite; else y stays and `non_finite` is returned. The sum shows it: what is not
/// finite cannot be cancelled.
inline Status take_over(const std::vector<Real>& next, Real* y) {
    Real sum = 0;
    for (const Real& entry : next) sum += entry;
    if (!isfinite(sum)) return Status::non_finite;
    std::copy(next.begin(), next.end(), y);
    return Status::ok;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
