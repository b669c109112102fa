// SPDX-License-Identifier: BSD-3-Clause
//
// Whether the experiment produces what its figures show.
#pragma once

#include <memory>
#include <vector>

#include "driver/plan/plan.hpp"
#include "plots/figures/figure.hpp"

namespace kreisel {

/// The figures that a config asks for; their shape was checked when it was read.
std::vector<std::unique_ptr<Figure>> figures_in(const Document& document, const Plan& plan);

/// Reports to `sink` each figure of the config that could not be drawn whatever the outcome of the cells: metrics that
/// the problems do not have or that are not measured, bodies that there are not, an end after that of the run, values
/// under `select` that the experiment has not, nor had before it was filtered. `metrics` are the names of all metrics
/// the problems of the plan have.
void check_figures(const Document& document, const Plan& plan, const std::vector<std::string>& metrics,
                   const Engine& engine, Diagnostics& sink);

/// Reports each figure whose selection fits no cell that is run, and each name of a curve in "legend" or "order" that
/// no cell that it fits can give. The plan has its cells.
void check_selections(const Document& document, const Plan& plan, Diagnostics& sink);

}  // namespace kreisel
