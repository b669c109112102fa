// SPDX-License-Identifier: BSD-3-Clause
//
// The first step of a run to a tolerance.
#pragma once

#include "mechanics/system.hpp"
#include "methods/control/error_norm.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// h of the first step from y at t towards t_end, which is another time: (tol/100)^(1/r) over the rate of the motion,
/// at most all of it, as if an error were (h rate)^r. What that is wrong by, a control corrects in a step or two.
/// `slope` is work space of dim TG reals, and becomes the vector field.
inline Status guess_first_step(System& system, ErrorNorm& norm, const Real& tolerance, int r, const Real& t,
                               const Real& t_end, const Real* y, Real* slope, Real& h) {
    if (const Status status = system.vector_field(t, y, slope); status != Status::ok) return status;
    const Real rate = norm.rate(slope), span = t_end - t;
    if (!isfinite(rate)) return Status::non_finite;
    Real size = abs(span);
    if (rate > 0) size = min(size, Real(pow(Real(tolerance / 100), Real(Real(1) / r)) / rate));
    h = span < 0 ? -size : size;
    return Status::ok;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
