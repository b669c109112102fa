// SPDX-License-Identifier: BSD-3-Clause
//
// `kreisel list configs`: the experiments that come with kreisel.
#pragma once

#include <iosfwd>

namespace kreisel {

/// Their names, each with what it says under "description". Throws ConfigError where one cannot be read.
void list_configs(std::ostream& out);

}  // namespace kreisel
