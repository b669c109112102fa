// SPDX-License-Identifier: BSD-3-Clause
//
// `kreisel atlas`: the data sheets of all methods in short, from results that are there.
#pragma once

#include "driver/cli/commands.hpp"

namespace kreisel {

/// For each registered method what it declares, its coefficients where they are few, and the orders that the
/// convergence studies in `folders` have observed of it, by the table `certification` (kreisel list tables). Nothing is
/// run. Prints them, or writes them as output/atlas.tex for a document that defines
///   \atlasmethod{name}{summary}{sources, a list of keys}{what it declares},
///   \atlascoefficients{a row in mathematics after another, separated by commas},
///   \atlasorders{a tabular}.
/// Throws FileError for a folder without results.
Exit atlas_command(const Paths& folders, const std::filesystem::path& output, const Engines& engines,
                   const Terminal& terminal);

}  // namespace kreisel
