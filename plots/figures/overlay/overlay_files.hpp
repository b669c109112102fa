// SPDX-License-Identifier: BSD-3-Clause
//
// Curves of figures from files of their own.
#pragma once

#include <string>

#include "records/json/diagnostics.hpp"

namespace kreisel {

/// Where figures at `pointer` of a document, an object or a list of them, have overlays {"file", "x", "y"}, the points
/// of that CSV file take the place of these keys, so that the document by itself says what is drawn. The path is
/// relative to the folder of the file that names it; x and y are titles of columns, with their unit or without. Throws
/// UsageError; FileError on files that cannot be read.
void insert_overlay_files(Document& document, const std::string& pointer);

}  // namespace kreisel
