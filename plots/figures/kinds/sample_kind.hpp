// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of running maxima over time, a curve for each cell with samples.
#pragma once

#include "plots/figures/kinds/curve_kind.hpp"

namespace kreisel {

class SampleKind : public CurveKind {
  public:
    using CurveKind::CurveKind;

  protected:
    std::vector<ResultRow> rows_of(const Results& results) const override;
    std::vector<CellGroup> groups_of(const std::vector<ResultRow>& rows) const override;
    bool names_steps() const override { return true; }
};

/// Why a cell did not finish, and when, in enhanced text; its samples are drawn up to there.
std::string end_text(const ResultRow& row);

}  // namespace kreisel
