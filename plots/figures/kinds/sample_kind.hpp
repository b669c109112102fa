// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of running maxima over time or cost, a curve for each cell with samples.
#pragma once

#include "plots/figures/kinds/curve_kind.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

class SampleKind : public CurveKind {
  public:
    using CurveKind::CurveKind;

    std::string x = "t";  ///< or a cost

    std::string drawn_against() const override { return x == "t" ? "" : x; }

  protected:
    /// Running maximum of a metric, times a factor; no points where it was not sampled.
    std::vector<Point> maxima(const TrajectoryTable& samples, const ResultRow& row, const std::string& metric,
                              double factor = 1) const;
    std::vector<ResultRow> rows_of(const FigureSpec& of, const Results& results) const override;
    std::vector<CellGroup> groups_of(const std::vector<ResultRow>& rows) const override;
    bool names_steps() const override { return true; }
};

/// The keys of such kinds.
std::vector<FigureKey> sample_keys(const std::string& family);

/// Why a cell did not finish, and when, in enhanced text; its samples are drawn up to there.
std::string end_text(const ResultRow& row);

}  // namespace kreisel
