// SPDX-License-Identifier: BSD-3-Clause
//
// How a process ended that should not have, in words.
#pragma once

#include <string>

namespace kreisel {

struct BadEnd {
    bool of_time = false;  ///< it met its CpuLimit
    std::string by;        ///< "SIGSEGV", "exit 3"
    std::string detail;
};

/// `status` as waitpid reports it.
BadEnd bad_end(int status);

}  // namespace kreisel
