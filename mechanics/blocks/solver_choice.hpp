// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// How to solve with a sparse matrix of blocks (mechanics/blocks/solvers.hpp); `automatic` decides by its structure.
enum class SolverChoice { automatic, dense, graph, sparse };

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
