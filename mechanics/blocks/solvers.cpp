// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/blocks/solvers.hpp"

#include "mechanics/blocks/dense_solver.hpp"
#include "mechanics/blocks/factor_pattern.hpp"
#include "mechanics/blocks/graph_solver.hpp"
#include "mechanics/blocks/sparse_solver.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr int most_dense_rows = 24;

SolverChoice choose(const BlockMatrix& pattern) {
    if (pattern.size <= most_dense_rows) return SolverChoice::dense;
    return 4 * fill_in(pattern) <= pattern.entries.size() ? SolverChoice::graph : SolverChoice::sparse;
}

}  // namespace

std::unique_ptr<BlockSolver> make_solver(const BlockMatrix& pattern, SolverChoice choice) {
    switch (choice == SolverChoice::automatic ? choose(pattern) : choice) {
        case SolverChoice::dense:
            return dense_solver(pattern);
        case SolverChoice::graph:
            return graph_solver(pattern);
        default:
            return sparse_solver(pattern);
    }
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
