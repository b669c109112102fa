// SPDX-License-Identifier: BSD-3-Clause
//
// One figure, as a config asks for it under "figure".
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "records/results.hpp"

namespace kreisel {

/// Thrown if a figure cannot be drawn from these results; says why.
struct FigureError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What figures of all kinds have in common.
struct FigureSpec {
    std::string pointer;  ///< where it stands in the config; empty for a standard figure
    std::string kind;
    std::string name;   ///< file name without extension
    std::string title;  ///< above the figure; empty: none
    std::string note;   ///< small: what is wanting of the results
    std::map<std::string, std::vector<std::string>>
        select;  ///< values by axis, "steps", "tolerance", and names of parameters and options; empty: all cells
};

/// A kind of figure derives from it: its members are the keys of the kind, with their defaults.
class Figure : public FigureSpec {
  public:
    Figure() = default;
    Figure(const Figure&) = delete;
    Figure& operator=(const Figure&) = delete;
    virtual ~Figure() = default;

    /// The metrics that it draws, as asked for; empty for a kind without.
    virtual std::vector<std::string> drawn_metrics() const { return {}; }

    /// What it draws them against, of those of plots/laws/abscissa.hpp; empty: the standard one of the kind, or its
    /// own.
    virtual std::string drawn_against() const { return ""; }

    /// The body that it draws; empty: the first, or no single one.
    virtual std::string drawn_body() const { return ""; }

    /// The time up to which it draws, s; nothing: all.
    virtual std::optional<double> drawn_until() const { return std::nullopt; }

    /// Writes plotdata/<name>.gp, the settings for the script of the kind, and its data files. Throws FigureError,
    /// FileError.
    virtual void write(const Results& results, const std::filesystem::path& folder) const = 0;
};

}  // namespace kreisel
