// SPDX-License-Identifier: BSD-3-Clause
//
// `kreisel certify`: the data sheet of a method.
#pragma once

#include <filesystem>
#include <string>

#include "driver/cli/commands.hpp"

namespace kreisel {

/// Runs the trials of a method (driver/cli/certify/trials.hpp) and prints its data sheet: what it declares, its
/// coefficients, stability on a test rotation, declared against observed orders by the rule of convergence studies,
/// what steps preserve, energy over 10,000 steps (if `is_long`, over a million), constraints and first integrals, cost,
/// and as remarks the properties that were seen and are not declared. With an `output` folder writes it there too, as
/// text, Markdown and LaTeX. Returns Exit::cells_failed, and says so, if an observed order falls short of the declared
/// one, a declared property is not there or has no cell that could show it, or a cell fails. Throws UsageError, with
/// the nearest name, for an unknown method.
Exit certify_command(const std::string& method, bool is_long, const std::filesystem::path& output,
                     const Engines& engines, const Terminal& terminal);

}  // namespace kreisel
