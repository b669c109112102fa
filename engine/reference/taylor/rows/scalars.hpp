// SPDX-License-Identifier: BSD-3-Clause
//
// What rows as power series share.
#pragma once

#include "engine/reference/taylor/row_series.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A series of zeros, as long as those of the ends.
inline Scalars scalars(const JointEnds& ends) { return Scalars(ends.d.size(), Real(0)); }

/// (k + 1)(k + 2): coefficient k of a second derivative over coefficient k + 2.
inline Real twice(std::size_t k) { return real(k + 1) * real(k + 2); }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
