// SPDX-License-Identifier: BSD-3-Clause
//
// What a document was made from, for those who put other files into it.
#pragma once

#include <filesystem>

#include "records/json/diagnostics.hpp"

namespace kreisel {

/// The layers of a document, with itself where it has none.
std::vector<Layer> layers_of(const Document& document);

/// The folder that a path written at `pointer` is relative to: that of the file which holds it; of a setting, that of
/// the document.
std::filesystem::path folder_of(const Document& document, const std::string& pointer);

}  // namespace kreisel
