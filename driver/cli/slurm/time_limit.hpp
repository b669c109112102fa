// SPDX-License-Identifier: BSD-3-Clause
//
// Times as Slurm writes them.
#pragma once

#include <optional>
#include <string>

namespace kreisel {

/// Seconds of MINUTES, MINUTES:SECONDS, HOURS:MINUTES:SECONDS, DAYS-HOURS, DAYS-HOURS:MINUTES or
/// DAYS-HOURS:MINUTES:SECONDS; empty for any other text, and for none at all (0).
std::optional<double> slurm_seconds(const std::string& written);

}  // namespace kreisel
