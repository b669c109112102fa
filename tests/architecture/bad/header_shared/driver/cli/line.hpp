// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace kreisel {

void add_run();
void add_options();

}  // namespace kreisel
