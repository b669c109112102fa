// SPDX-License-Identifier: BSD-3-Clause
//
// How tables and figures name cells and quantities.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "records/results.hpp"

namespace kreisel {

/// Names of cells relative to the cells beside them: a method is shown with those of its options that vary, and as
/// "adaptive" where it has both constant steps and tolerances. A `label` among its options stands for those that have
/// one value under each label.
class CellNames {
  public:
    explicit CellNames(const std::vector<ResultRow>& rows);

    /// "results" (of one folder among several), "problem" (the label), "formulation", "method" (with varying options),
    /// "projection", "precision".
    std::string axis(const ResultRow& row, const std::string& axis) const;
    /// The axes that vary among the rows, without `left_out`.
    std::vector<std::string> varying_axes(const std::vector<std::string>& left_out) const;
    /// The values of `axes`, separated by commas; only the method if nothing varies.
    std::string legend(const ResultRow& row, const std::vector<std::string>& axes) const;

    /// The axes of an experiment.
    static const std::vector<std::string>& axes();
    /// Those of figures: "results", of several folders, and the same.
    static const std::vector<std::string>& figure_axes();

  private:
    const std::vector<ResultRow>& rows_;
    std::map<std::string, std::vector<std::string>> varying_options_;  ///< by method, and by projection
    std::map<std::string, std::set<std::string>> labelled_options_;    ///< by method: what its labels stand for
    std::set<std::string> adaptive_, constant_;                        ///< methods with such steps
};

/// The options of a method or a projection as names show them behind its own, in this order, those that vary:
/// its label, "cayley", "dexpinv=2".
std::vector<std::string> option_texts(const std::map<std::string, std::string>& options);

/// Rows that differ in their number of steps or their tolerance only, in the order of first appearance.
struct CellGroup {
    std::vector<const ResultRow*> rows;
    const ResultRow& front() const { return *rows.front(); }
};
std::vector<CellGroup> group_by_method(const std::vector<ResultRow>& rows);

/// Rows in groups of those that are `same` as the first of their group, in the order of first appearance.
std::vector<CellGroup> grouped(const std::vector<ResultRow>& rows, bool (*same)(const ResultRow&, const ResultRow&));

/// Whether two rows agree in all but parameters, steps and end time.
bool same_but_for_size(const ResultRow& a, const ResultRow& b);

}  // namespace kreisel
