// SPDX-License-Identifier: BSD-3-Clause
//
// Durations and sizes for readers.
#pragma once

#include <string>

namespace kreisel {

/// "1 h 02 min", "3 min 07 s", "12 s", "0.4 s".
std::string duration_text(double seconds);

/// "512 B", "40 MB", "2.5 GB".
std::string size_text(double bytes);

}  // namespace kreisel
