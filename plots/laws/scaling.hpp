// SPDX-License-Identifier: BSD-3-Clause
//
// Time and memory against the number of bodies.
#pragma once

#include <optional>

#include "plots/tables/names.hpp"

namespace kreisel {

/// A cost of a cell and how it is drawn.
struct ScalingQuantity {
    std::string name;   ///< "cost.step"
    std::string label;  ///< enhanced text of gnuplot
    double unit = 1;    ///< of the axis, in s or bytes
    bool per_body = false;
};

/// cost.step, cost.step_per_body (s), cost.memory, cost.memory_per_body (bytes).
const std::vector<ScalingQuantity>& scaling_quantities();

/// Nothing if it was not measured.
std::optional<double> scaling_value(const ResultRow& row, const std::string& quantity);

/// Rows labelled by their series, so that those of one list of parameters belong together.
std::vector<ResultRow> by_series(std::vector<ResultRow> rows);

/// Rows of `by_series` that differ in their number of bodies only, fewest bodies first.
std::vector<CellGroup> scaling_curves(const std::vector<ResultRow>& rows);

/// y = coefficient N^exponent, fitted to log y against log N with equal weights; the standard error of the exponent.
struct ScalingLaw {
    double exponent = 0, error = 0, coefficient = 0;
    long from = 0, to = 0;  ///< numbers of bodies
};

/// The fewest bodies that a law is fitted to.
inline constexpr long least_bodies = 8;

/// From that many bodies on: for fewer, the constant cost of a step dominates. Nothing with fewer than three sizes.
std::optional<ScalingLaw> scaling_law(const CellGroup& curve, const std::string& quantity);

}  // namespace kreisel
