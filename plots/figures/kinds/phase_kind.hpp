// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of two quantities of a body against each other, a curve for each cell with samples.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plots/figures/kinds/panel_kind.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

class PhaseKind : public PanelKind {
  public:
    std::string body;                ///< empty: the first
    std::string x = "x1", y = "v1";  ///< of phase_quantities()
    std::optional<double> until;     ///< s

    std::string drawn_body() const override { return body; }
    std::optional<double> drawn_until() const override { return until; }

  protected:
    PanelFigure make_panels(const Results& results) const final;
    /// What is drawn of the samples of a cell, whose body has columns that begin with `prefix`, "BODY.".
    virtual std::vector<Point> points_of(const TrajectoryTable& samples, const std::string& prefix) const = 0;
    /// What the trajectories lack if there is nothing to draw: "no trajectory has samples".
    virtual std::string lacking() const { return "no trajectory has samples"; }
    /// A column of the body. Throws FigureError where there is none.
    const std::vector<double>& column(const TrajectoryTable& samples, const std::string& prefix,
                                      const std::string& quantity) const;
};

/// The components of x, v and omega: "x1".
const std::vector<std::string>& phase_quantities();
/// A key of such a quantity.
figure_value::Type<std::string> phase_quantity();
/// The keys of such kinds.
std::vector<FigureKey> phase_keys();

}  // namespace kreisel
