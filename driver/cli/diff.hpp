// SPDX-License-Identifier: BSD-3-Clause
//
// Two results folders beside each other.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>

#include "support/errors.hpp"

namespace kreisel {

struct DiffSettings {
    std::filesystem::path a, b;
    std::filesystem::path csv;     ///< CSV file for every difference; empty: none
    std::optional<double> within;  ///< see compare_cells; positive
};

/// `kreisel diff A B`: prints the differences. Exit::ok if there are none, Exit::cells_failed if there are some,
/// Exit::io if lines are damaged; the output then covers the other lines. Throws FileError.
Exit diff_command(const DiffSettings& settings, std::ostream& out, std::ostream& messages);

}  // namespace kreisel
