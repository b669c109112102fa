// SPDX-License-Identifier: BSD-3-Clause
//
// How the options of methods and projections are read. Internal to the reader.
#pragma once

#include <string>
#include <vector>

#include "methods/contract/description.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// The values an option takes, in words; `expectation` names the option too.
std::string allowed_values(const OptionDescription& option);
std::string expectation(const OptionDescription& option);

/// All combinations of the options written beside "name" in `written` (an object), an option given as a list being an
/// axis, but for texts; the last option of the description varies fastest.
std::vector<OptionValues> read_options(const Node& written, const std::vector<OptionDescription>& options);
std::vector<OptionValues> default_options(const std::vector<OptionDescription>& options);

}  // namespace kreisel
