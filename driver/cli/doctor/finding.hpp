// SPDX-License-Identifier: BSD-3-Clause
//
// One thing that `kreisel doctor` has looked at.
#pragma once

#include <string>

namespace kreisel {

/// `missing`: not there, which only some commands need; `poor`: there, and may not do; `failed`: does not work.
enum class Health { well, missing, poor, failed };

struct Finding {
    std::string topic;  ///< "gnuplot"
    Health health = Health::well;
    std::string found;   ///< "5.4 patchlevel 4"
    std::string advice;  ///< what to do; empty: nothing
};

}  // namespace kreisel
