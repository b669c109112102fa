// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of curves: a panel for each facet and metric, and in it a curve for each group of cells.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plots/figures/kind.hpp"
#include "plots/figures/kinds/panel_kind.hpp"
#include "plots/tables/names.hpp"

namespace kreisel {

/// One curve as a kind draws it. The legend is the name of its cells and the remark, which is enhanced text.
struct DrawnCurve {
    std::vector<Point> points;
    std::string remark;
    std::vector<Point> guide = {};   ///< a fitted law; empty: none
    std::vector<Point> fitted = {};  ///< the points it was fitted to
};

/// A kind says which rows it draws, which of them form a curve, and what a panel and a curve look like.
class CurveKind : public PanelKind {
  public:
    explicit CurveKind(std::vector<std::string> drawn) : metrics(std::move(drawn)) {}

    std::vector<std::string> metrics;
    std::string facet;  ///< an axis; empty: no facets

    std::vector<std::string> drawn_metrics() const override { return metrics; }

  protected:
    PanelFigure make_panels(const Results& results) const final;
    /// Those that the figure `of` draws.
    virtual std::vector<ResultRow> rows_of(const FigureSpec& of, const Results& results) const = 0;
    virtual std::vector<CellGroup> groups_of(const std::vector<ResultRow>& rows) const = 0;
    /// Labels and scales of the panels of a metric; nothing for one that is not drawn.
    virtual std::optional<Panel> empty_panel(const std::string& metric, const Units& units) const = 0;
    /// Nothing where the group has no such metric.
    virtual std::optional<DrawnCurve> curve(const CellGroup& group, const std::string& metric) const = 0;
    /// Adds to a panel what belongs to all of its curves.
    virtual void complete(Panel& /*panel*/, const std::vector<CellGroup>& /*drawn*/,
                          const std::string& /*metric*/) const {}
    /// What the cells lack if there is nothing to draw: "such error".
    virtual std::string lacking() const = 0;
    /// Whether legends name the step sizes, where these vary.
    virtual bool names_steps() const { return false; }
};

/// The keys of such kinds, whose metrics are of families such as "error.", or their own.
std::vector<FigureKey> layout_keys();  ///< those of how panels stand and look
std::vector<FigureKey> curve_keys(const std::vector<std::string>& families, const std::vector<std::string>& own = {});

/// Axis label of a metric in enhanced text, with its unit.
std::string metric_label(const std::string& metric, const Units& units);

}  // namespace kreisel
