// SPDX-License-Identifier: BSD-3-Clause
//
// The least change of a start that removes the residuals of its rows.
#pragma once

#include "mechanics/start/start_state.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The least change (n) in the metric M with C change = -residual in the first `rows` rows, each divided by its scale.
/// Least squares where the rows contradict each other; their rank is that of C, whatever the masses and units.
VecX least_correction(StartState& start, Eigen::Index rows, const VecX& residual);

/// The same for a part of the coordinates.
struct LeastCorrection {
    VecX change;            ///< 0 in the others
    Eigen::Index free = 0;  ///< directions in which these coordinates may change without a residual
    VecX freedom;           ///< of each coordinate, in [0, 1]: 0 where no free direction has a part of it
};
LeastCorrection least_correction(StartState& start, Eigen::Index rows, const VecX& residual,
                                 const std::vector<bool>& coordinates);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
