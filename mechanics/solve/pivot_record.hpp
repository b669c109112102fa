// SPDX-License-Identifier: BSD-3-Clause
//
// How close to a loss of rank the solves of a system have come.
#pragma once

#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Offered by systems whose constraints can lose rank along a motion, beside `System`.
class PivotRecord {
  public:
    virtual ~PivotRecord() = default;
    /// The smallest pivot, relative to its diagonal entry, of all factorisations since the last call; 1 without any.
    virtual Real least_pivot() = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
