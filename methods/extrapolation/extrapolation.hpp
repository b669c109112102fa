// SPDX-License-Identifier: BSD-3-Clause
//
// Extrapolation of a fixed order p = 2k: k rows of a base method (methods/extrapolation/base.hpp) with 2, 4, ..., 2k
// substeps, and from them T_kk (methods/extrapolation/neville.hpp). The estimate of the error is T_kk - T_{k,k-1}, in
// the coordinates of the base method.
#pragma once

#include <functional>

#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class ExtrapolationBase;
struct Work;

using MakeExtrapolationBase = std::function<std::unique_ptr<ExtrapolationBase>(System&, Work&)>;

/// Gragg's rule in the chart of exp around the start of a step: a Munthe-Kaas method with an explicit tableau
/// (methods/extrapolation/gragg_tableau.hpp). Order 2 `columns`, with columns > 1.
Factory gragg(int columns);

/// The rule on the group, which needs no inverse differential. Order 2 `columns`, with columns > 1.
Factory lie_midpoint(int columns);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
