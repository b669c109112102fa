// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A step from t to `end`, in the direction of a limit.
struct FittedStep {
    Real h, end;
    bool shortened;  ///< it is not the proposed one, because the limit is near
};

/// A step of about the proposed size that does not pass the limit: the proposed one; what is left, where that is less,
/// or up to 1/100 more; or half of what is left, where the proposed one would leave a small rest.
inline FittedStep fit(const Real& t, const Real& proposed, const Real& limit) {
    const Real left = limit - t, size = abs(proposed), rest = abs(left);
    if (rest <= size + size / 100) return {left, limit, rest < size};
    if (rest < 2 * size) return {left / 2, t + left / 2, true};
    return {proposed, t + proposed, false};
}

/// Whether a step no longer moves the time, at its place or as a part of the way to the limit: t may be 0.
inline bool is_too_small(const FittedStep& step, const Real& t, const Real& limit) {
    return !(abs(step.h) > epsilon * max(Real(abs(t)), Real(abs(limit))));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
