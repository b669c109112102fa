// SPDX-License-Identifier: BSD-3-Clause
//
// The files of driver/scaffolds/, which the build puts into the program (cmake/scaffolds.cmake).
#pragma once

#include <map>
#include <string>

namespace kreisel {

/// By their names without ending: "experiment", "problem", and "method.FAMILY" for each family that has one.
const std::map<std::string, std::string>& scaffold_texts();

}  // namespace kreisel
