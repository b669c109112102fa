// SPDX-License-Identifier: BSD-3-Clause
//
// gnuplot as a child process, without a shell in between.
#pragma once

#include <filesystem>
#include <string>

namespace kreisel {

/// The folder of the gnuplot scripts: the environment variable KREISEL_PLOTS, else ../share/kreisel/plots beside this
/// program, else plots/gnuplot/ of the sources it was built from. Throws FileError where none exists.
std::filesystem::path plot_scripts();

/// Runs `gnuplot -d -c scripts/<script>.gp plotdata/<name>.gp figures/<name> scripts` in `folder`. Returns what it
/// wrote to its error stream; throws FileError, with that text, if it cannot be started or fails.
std::string run_gnuplot(const std::filesystem::path& folder, const std::filesystem::path& scripts,
                        const std::string& script, const std::string& name);

}  // namespace kreisel
