// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mechanics/blocks/block_solver.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Block LDL^T along the joint graph, in an order without fill-in for chains and trees.
std::unique_ptr<BlockSolver> graph_solver(const BlockMatrix& pattern);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
