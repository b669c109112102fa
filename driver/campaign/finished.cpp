// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/finished.hpp"

namespace kreisel {

namespace {

CellEnd end_of(const CellOutcome& outcome) {
    if (outcome.failed()) { return CellEnd::failed; }
    return outcome.status == status::ok ? CellEnd::ok : CellEnd::skipped;
}

}  // namespace

CellEnding ending_of(const CellOutcome& outcome) {
    const bool past_horizon = outcome.reference && outcome.reference->past_horizon;
    return {end_of(outcome), outcome.lost.has_value() || past_horizon};
}

void FinishedCells::set(std::size_t index, const CellEnding& ending, const JournalPlace& place) {
    size_ += has(index) ? 0U : 1U;
    cells_[index] = {place, ending};
}

}  // namespace kreisel
