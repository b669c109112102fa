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
    std::filesystem::path csv;     ///< where every difference goes as CSV; empty: nowhere
    std::optional<double> within;  ///< see compare_cells; positive
};

/// `kreisel diff A B`: prints what differs. Exit::ok where nothing does, Exit::cells_failed where something does,
/// Exit::io where lines are damaged: what is said then is of the others. Throws FileError.
Exit diff_command(const DiffSettings& settings, std::ostream& out, std::ostream& messages);

}  // namespace kreisel
