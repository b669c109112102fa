// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mechanics/blocks/block_solver.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Scalar sparse LDL^T in an approximate minimum degree order: for many loops.
std::unique_ptr<BlockSolver> sparse_solver(const BlockMatrix& pattern);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
