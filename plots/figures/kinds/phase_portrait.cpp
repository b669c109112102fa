// SPDX-License-Identifier: BSD-3-Clause
//
// Phase portraits.
#include "plots/figures/kinds/phase_kind.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

namespace {

class PhaseFigure final : public PhaseKind {
    std::vector<Point> points_of(const TrajectoryTable& samples, const std::string& prefix) const override {
        return zipped(column(samples, prefix, x), column(samples, prefix, y));
    }
};

}  // namespace

KREISEL_FIGURE(PhaseFigure, {.name = "phase_portrait",
                             .summary = "two components of x, v or omega of a body against each other",
                             .draws = FigureData::samples,
                             .script = "lines",
                             .keys = phase_keys()});

}  // namespace kreisel
