// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mechanics/blocks/block_solver.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The solver for matrices with the pattern of `pattern`: of the chosen kind, or by `automatic` dense for few rows,
/// along the graph where that has next to no fill-in, else sparse.
std::unique_ptr<BlockSolver> make_solver(const BlockMatrix& pattern, SolverChoice choice);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
