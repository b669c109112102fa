// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/estimate/amounts.hpp"

#include <fmt/format.h>

#include <cmath>

namespace kreisel {

std::string duration_text(double seconds) {
    constexpr double year = 3.156e7, most_years = 1000;
    if (seconds < 10) { return fmt::format("{:.1f} s", seconds); }
    if (seconds >= most_years * year) { return fmt::format("{:.1e} years", seconds / year); }
    const long whole = std::lround(seconds);
    if (whole >= 3600) { return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60); }
    return whole >= 60 ? fmt::format("{} min {:02} s", whole / 60, whole % 60) : fmt::format("{} s", whole);
}

std::string size_text(double bytes) {
    const char* unit = "B";
    for (const char* larger : {"kB", "MB", "GB", "TB", "PB"}) {
        if (bytes < 1000) { break; }
        bytes /= 1000;
        unit = larger;
    }
    return bytes < 9.95 && unit[1] != '\0' ? fmt::format("{:.1f} {}", bytes, unit)
                                           : fmt::format("{:.0f} {}", bytes, unit);
}

}  // namespace kreisel
