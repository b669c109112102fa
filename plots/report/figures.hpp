// SPDX-License-Identifier: BSD-3-Clause
//
// The figures of a folder as data of the page: the curves that gnuplot draws.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "plots/figures/panels.hpp"
#include "records/results.hpp"

namespace kreisel {

struct ReportFigures {
    std::string json;                    ///< a list of objects
    std::vector<std::string> not_drawn;  ///< why, a text for each figure that could not be drawn
};

/// A list of {"name", "kind", "title"} with "columns", "marks" and "panels", of a heat map with "heat", of a figure in
/// space with "space" (plots/report/places.hpp), or with "not_drawn", why. Labels are enhanced text of gnuplot. A curve
/// has "x" (or the index of an earlier curve with the same), "y" (null: a gap), "style", "fitted" (indices).
ReportFigures report_figures(const Results& results);

/// A panel as JSON, for tests.
std::string json_value(const Panel& panel);

}  // namespace kreisel
