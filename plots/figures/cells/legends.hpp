// SPDX-License-Identifier: BSD-3-Clause
//
// What the curves of cells are called, and how they look.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "plots/tables/names.hpp"

namespace kreisel {

/// Names of groups in a legend, with step sizes or tolerances if these are named and vary.
class Legends {
  public:
    /// Refers to `names`, those of `rows`. `facet`: an axis that is not named; empty: none.
    Legends(const std::vector<ResultRow>& rows, const CellNames& names, const std::string& facet, bool names_steps);

    std::string name(const ResultRow& row) const;
    const std::vector<std::string>& axes() const { return axes_; }
    bool with_steps() const { return with_steps_; }

  private:
    const CellNames& names_;
    std::vector<std::string> axes_;
    bool with_steps_ = false;
};

/// Styles of curves, numbered over all cells of a run, so that those of one name look the same in all of its figures.
/// Where methods differ each has a colour, whatever else differs.
class Styles {
  public:
    /// Refers to `all`.
    Styles(const std::vector<ResultRow>& all, const Legends& legends);
    int of(const ResultRow& row);

  private:
    /// Numbers of texts in the order in which they come.
    class Ranks {
      public:
        int of(const std::string& text) { return ranks_.insert({text, size()}).first->second; }
        int size() const { return static_cast<int>(ranks_.size()); }

      private:
        std::map<std::string, int> ranks_;
    };
    std::string hue(const ResultRow& row) const { return by_method_ ? names_.axis(row, "method") : rest(row); }
    std::string variant(const ResultRow& row) const { return by_method_ ? rest(row) : ""; }
    std::string rest(const ResultRow& row) const;

    CellNames names_;
    std::vector<std::string> axes_;  // but for the method
    bool by_method_ = false, with_steps_ = false;
    Ranks hues_, variants_;
};

}  // namespace kreisel
