// SPDX-License-Identifier: BSD-3-Clause
//
// How a config asks for figures under "figure": one object or a list of them, each with a "kind" and keys of that kind.
// `kreisel list figures` shows the kinds, `kreisel info KIND` the keys of one.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "plots/figures/figure.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// Reads the value of the key "figure". Reports errors to the node's diagnostics: JSON pointer, what was
/// expected, what came; figures with such errors are left out. `experiment` gives the default name.
std::vector<std::unique_ptr<Figure>> read_figures(const Node& figure, const std::string& experiment);

/// The figures that a file describes, a JSON object or a list of them. `experiment` gives the default name. Throws
/// UsageError where they cannot be read, FileError.
std::vector<std::unique_ptr<Figure>> figures_in_file(const std::filesystem::path& file, const std::string& experiment);

/// A figure of that kind with all keys at their defaults. Throws FigureError where there is no such kind.
std::unique_ptr<Figure> standard_figure(const std::string& kind, const std::string& experiment);

/// The figures of a folder: those that its config asks for, else one of the kind of the experiment. Throws FigureError,
/// FileError where the manifest holds no config.
std::vector<std::unique_ptr<Figure>> figures_of(const Results& results);

}  // namespace kreisel
