// SPDX-License-Identifier: BSD-3-Clause
//
// What a reader of results says of what is not there.
#pragma once

#include "records/results.hpp"

namespace kreisel {

/// Prints to the error stream the warning that an older folder deserves, what is damaged, and each cell that is missing
/// or has failed, a line each.
void print_wanting(const Results& results);

}  // namespace kreisel
