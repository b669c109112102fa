// SPDX-License-Identifier: BSD-3-Clause
//
// How options that take texts are read (OptionText): labels, exact numbers and rows of them. Internal to the reader.
#pragma once

#include <optional>
#include <string>

#include "methods/contract/description.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// The longest label, in bytes.
inline constexpr std::size_t longest_option_label = 64;

/// What such an option takes, in words.
std::string allowed_text(OptionText text);

/// The text in its one form, numbers apart by one blank, "0 1/2", and rows by "; ", whether it is written as a text or
/// as a list. Nothing, with an error, if it is neither.
std::optional<std::string> read_text_option(const Node& node, const OptionDescription& option);

}  // namespace kreisel
