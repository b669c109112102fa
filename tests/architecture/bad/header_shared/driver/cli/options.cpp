// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/line.hpp"

namespace kreisel {

void add_options() {}

}  // namespace kreisel
