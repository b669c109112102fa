// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of panels with axes.
#pragma once

#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/figure.hpp"
#include "plots/figures/panels.hpp"

namespace kreisel {

class PanelKind : public Figure {
  public:
    long columns = 2;  ///< panels beside each other

    virtual PanelFigure panels(const Results& results, const std::filesystem::path& folder) const = 0;

    void write(const Results& results, const std::filesystem::path& folder) const override {
        PanelFigure figure = panels(results, folder);
        figure.note = enhanced_escape(note);
        write_panels(folder / "plotdata", figure);
    }
};

/// (x_i, factor y_i).
inline std::vector<Point> zipped(const std::vector<double>& x, const std::vector<double>& y, double factor = 1) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < x.size(); ++i) { points.push_back({x[i], factor * y[i]}); }
    return points;
}

}  // namespace kreisel
