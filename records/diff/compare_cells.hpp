// SPDX-License-Identifier: BSD-3-Clause
//
// What differs between two results folders.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "records/diff/recorded_cell.hpp"

namespace kreisel {

/// One number that moved, or that only one side has: `a` or `b` is then empty and the distances are 0.
struct QuantityDifference {
    std::string name, family;
    std::string a, b;     ///< the numbers as text
    double ulps = 0;      ///< see NumberDistance
    double relative = 0;  ///< to the larger one of both
    double of_scale = 0;  ///< relative to the scale of the quantity in this cell (quantity_scale.hpp); 0 for counts
};

/// What differs between two records of one cell. Quantities of cells whose status changed are not compared.
struct CellDifference {
    const RecordedCell* a;
    const RecordedCell* b;
    std::vector<QuantityDifference> quantities;
    bool status_changed() const { return a->status != b->status; }
    /// The number furthest away by its scale, of those that both sides have; null where there is none.
    const QuantityDifference* furthest() const;
};

/// Points into the cells it was made from.
struct CellComparison {
    std::size_t cells_a = 0, cells_b = 0, same = 0;
    std::vector<const RecordedCell*> only_a, only_b;
    std::vector<CellDifference> changed;  ///< in the order of A
    std::vector<std::string> notes;       ///< on how cells were matched, and what was not compared
    bool differs() const { return !only_a.empty() || !only_b.empty() || !changed.empty(); }
};

/// Without `within` every number of the lines is compared to the last bit, and so are the check sums of samples. With
/// it, final states and metrics only: a number counts as moved if it is further away than `within` times the scale of
/// its quantity. Numbers that no cell of one side has, for instance because its version did not compute them, are then
/// noted and skipped.
CellComparison compare_cells(const std::vector<RecordedCell>& a, const std::vector<RecordedCell>& b,
                             std::optional<double> within);

}  // namespace kreisel
