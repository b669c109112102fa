// SPDX-License-Identifier: BSD-3-Clause
//
// What a config may ask for under "figure": one object or a list of them. Each gives one figure.
//
//   kind      path3d, motion, components, convergence, drift, invariants, scaling
//   name      file name without extension: small letters, digits, "_", "-"; default: the name of the experiment
//   title     text above the figure; default none
//   select    cells to draw: {"problem": "slow", "formulation": ["SO3xR3", "SE3"], "steps": 1000, ...}, keys: problem
//             (the label), formulation, method, projection, precision, steps; default all
//   facet     convergence, drift, invariants, scaling: one panel per value of problem, formulation, method, projection,
//             precision
//   metric    convergence, drift, invariants, scaling: one metric, or a list, a panel each
//   relative  invariants: divide by |I0| (false)
//   body      path3d, motion, components: name of the body; default the first
//   quantity  components: x, v, omega or multipliers ("x")
//   stacked   components: one panel per component (false)
//   until     path3d, motion, components: draw the samples up to this time, s; default all
//   instants  motion: how many tops are drawn, evenly spaced over time (9)
//   radius    motion: radius of the drawn rim, m (0.3)
//   lever     motion: from the tip of the drawn top to the mass centre, body axes, m; default the problem's `lever`
//   view      path3d, motion: [elevation, azimuth] in degrees ([65, 35])
//   columns   panels beside each other, 1 to 4 (2)
//
// path3d, motion and components draw one trajectory: `select` must leave one cell with samples.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "records/json/node.hpp"

namespace kreisel {

struct FigureSpec {
    std::string pointer;  ///< where it stands in the config; empty for a standard figure
    std::string kind, name, title, facet, body;
    std::string quantity = "x";
    std::map<std::string, std::vector<std::string>> select;
    std::vector<std::string> metrics;
    bool relative = false, stacked = false;
    long instants = 9, columns = 2;
    double radius = 0.3;
    std::optional<std::array<double, 3>> lever;
    std::optional<double> until;
    std::array<double, 2> view = {65, 35};
};

/// Reads the value of the key "figure". Reports errors to the node's diagnostics: JSON pointer, what was
/// expected, what came. `experiment` gives the default name.
std::vector<FigureSpec> read_figures(const Node& figure, const std::string& experiment);

/// True if the kind draws trajectories, of which the experiment must store samples.
bool draws_samples(const std::string& kind);

/// The figure drawn for an experiment that asks for none: `kind` convergence, drift, or trajectory (components).
FigureSpec standard_figure(const std::string& kind, const std::string& experiment);

/// True for a name that is safe as a file name everywhere: 1 to 80 of a-z, 0-9, "_", "-", not "-" in front.
bool is_figure_name(const std::string& name);

}  // namespace kreisel
