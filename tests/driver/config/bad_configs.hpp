// SPDX-License-Identifier: BSD-3-Clause
//
// Configs with one error each.
#pragma once

#include <string>
#include <vector>

namespace kreisel {

/// A change of the good config (RFC 7396 merge patch: null removes a key) that makes it bad.
struct BadConfig {
    std::string patch;
    std::string pointer;  ///< location of the error
    std::string phrase;   ///< required text of the message
};

const std::vector<BadConfig>& bad_configs();

/// Texts that are not configs at all.
const std::vector<BadConfig>& bad_texts();

}  // namespace kreisel
