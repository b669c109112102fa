// SPDX-License-Identifier: BSD-3-Clause
//
// Metrics of cells as colours of the places between two axes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "plots/figures/kind.hpp"
#include "plots/figures/panels.hpp"

namespace kreisel {

struct HeatMapData {
    struct Place {
        std::size_t x = 0, y = 0;  ///< which values of the axes
        double value = 0;
    };
    /// The places that have a metric.
    struct Map {
        std::string label;  ///< enhanced text
        std::vector<Place> places;
    };
    std::string x_label, y_label;  ///< enhanced text
    std::vector<std::string> x_values, y_values;
    bool log = true;                           ///< whether the scale of colours is logarithmic
    std::vector<Map> maps;                     ///< one for each metric
    std::optional<double> width, axes_height;  ///< of the page and of the axes of a map, cm
    double font_size = standard_font_size;     ///< points
};

class HeatMapKind : public Figure {
  public:
    /// What is drawn. Throws FigureError.
    virtual HeatMapData data(const Results& results) const = 0;
};

}  // namespace kreisel
