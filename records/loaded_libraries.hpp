// SPDX-License-Identifier: BSD-3-Clause
//
// What numbers depend on beside the program itself: the libraries it has loaded, and the instructions that these choose
// between when they start.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace kreisel {

/// File names of the loaded libraries that compute or convert numbers, with the build id that their linker gave them
/// (the note NT_GNU_BUILD_ID, in hexadecimal digits; empty where there is none), by name.
std::vector<std::pair<std::string, std::string>> numerical_libraries();

/// The best of "x86-64", "x86-64-v2", "-v3", "-v4" that processor, system and GLIBC_TUNABLES allow, by which glibc
/// chooses its mathematical functions; on other processors the name of the machine.
std::string instruction_level();

}  // namespace kreisel
