// SPDX-License-Identifier: BSD-3-Clause
//
// Declared against observed orders at a glance: a line per method, a column per formulation.
#pragma once

#include <vector>

#include "plots/tables/names.hpp"
#include "plots/tables/text.hpp"

namespace kreisel {

/// One table for each problem (by label) of a convergence study, named "certification", or "certification_<label>"
/// where there are several. A cell holds the observed orders of configuration, velocity and multipliers: the least over
/// the metrics of each that have one, "-" where none does; "?" where the slopes of a metric have not settled; "!" where
/// one does not converge, or its order and the finest local slope of its window fall short of the declared one by more
/// than `order_tolerance`.
std::vector<TextTable> certification_tables(const Results& results);

/// How far an observed order may fall short of the declared one.
double order_tolerance(int declared);

}  // namespace kreisel
