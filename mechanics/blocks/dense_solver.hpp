// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "mechanics/blocks/block_solver.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Dense Cholesky factors: for few rows.
std::unique_ptr<BlockSolver> dense_solver(const BlockMatrix& pattern);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
