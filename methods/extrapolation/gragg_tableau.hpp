// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods/tableaus/tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The explicit Runge-Kutta pair that the extrapolation of Gragg's rule amounts to: k rows of 2, 4, ..., 2k substeps,
/// b of T_kk and b^ of T_{k,k-1}. Exact up to k = 6 at least.
Tableau gragg_tableau(int columns);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
