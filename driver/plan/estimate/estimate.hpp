// SPDX-License-Identifier: BSD-3-Clause
//
// What a run of a plan takes, before it runs.
#pragma once

#include <string>

#include "driver/plan/plan.hpp"

namespace kreisel {

/// By order of magnitude.
struct Estimate {
    double seconds = 0;  ///< of CPU, with all references and every cell
    double memory = 0;   ///< bytes of the program and one worker
    double disk = 0;     ///< bytes of journal, results and samples
};

Estimate estimate_of(const Plan& plan);

/// "about 12 s of CPU time, 40 MB of memory, 3 MB on disk".
std::string estimate_text(const Estimate& estimate);

}  // namespace kreisel
