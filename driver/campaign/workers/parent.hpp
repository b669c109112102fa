// SPDX-License-Identifier: BSD-3-Clause
//
// Processes that do not outlive the one that has made them.
#pragma once

#include <sys/types.h>

namespace kreisel {

/// This process is killed when its parent ends, however that ends, or at once if that was no longer `parent`.
void die_with(pid_t parent);

}  // namespace kreisel
