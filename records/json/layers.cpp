// SPDX-License-Identifier: BSD-3-Clause
#include "records/json/layers.hpp"

namespace kreisel {

std::vector<Layer> layers_of(const Document& document) {
    if (!document.layers.empty()) { return document.layers; }
    return {{"", std::make_shared<const Document>(document)}};
}

std::filesystem::path folder_of(const Document& document, const std::string& pointer) {
    const Document& writer = writer_of(document, pointer);
    return std::filesystem::path(writer.file.starts_with("--set ") ? document.file : writer.file).parent_path();
}

}  // namespace kreisel
