// SPDX-License-Identifier: BSD-3-Clause
//
// Figures of panels with axes, and how these look.
#pragma once

#include <array>
#include <map>
#include <optional>

#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/kind.hpp"
#include "plots/figures/overlay/overlay.hpp"
#include "plots/figures/panels.hpp"

namespace kreisel {

class PanelKind : public Figure {
  public:
    long columns = 2;                                       ///< panels beside each other
    std::optional<std::array<double, 2>> x_range, y_range;  ///< nothing: all that is drawn
    std::string x_scale, y_scale;                           ///< "log" or "linear"; empty: that of the kind
    std::optional<double> width, height;                    ///< of the page and of the axes of a panel, mm
    double font_size = standard_font_size;                  ///< points
    std::map<std::string, std::string> legend;              ///< what curves are called, by their names
    std::vector<std::string> order;                         ///< names of curves that come first
    std::vector<Overlay> overlays;                          ///< curves beside those of the cells

    /// What is drawn. Throws FigureError.
    PanelFigure panels(const Results& results) const;

    void write(const Results& results, const std::filesystem::path& folder) const override {
        PanelFigure figure = panels(results);
        figure.note = enhanced_escape(note);
        write_panels(folder / "plotdata", figure);
    }

  protected:
    /// The panels as the kind makes them, whose curves have names. Throws FigureError.
    virtual PanelFigure make_panels(const Results& results) const = 0;
    /// What a curve of that name is called, as enhanced text.
    std::string label_of(const std::string& curve) const;
};

/// The keys of how panels look, which all such kinds have.
std::vector<FigureKey> look_keys();

/// (x_i, factor y_i).
inline std::vector<Point> zipped(const std::vector<double>& x, const std::vector<double>& y, double factor = 1) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < x.size(); ++i) { points.push_back({x[i], factor * y[i]}); }
    return points;
}

}  // namespace kreisel
