// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/slurm/time_limit.hpp"

#include <regex>

namespace kreisel {

std::optional<double> slurm_seconds(const std::string& written) {
    static const std::regex pattern(R"((?:(\d{1,6})-)?(\d{1,9})(?::(\d{1,9}))?(?::(\d{1,9}))?)");
    std::smatch found;
    if (!std::regex_match(written, found, pattern)) { return std::nullopt; }
    const auto number = [&](std::size_t i) { return found[i].matched ? std::stod(found[i]) : 0.0; };
    const bool from_hours = found[1].matched || found[4].matched;
    constexpr double minute = 60, hour = 3600, day = 86400;
    const double seconds = from_hours ? number(1) * day + number(2) * hour + number(3) * minute + number(4)
                                      : number(2) * minute + number(3);
    return seconds > 0 ? std::optional(seconds) : std::nullopt;
}

}  // namespace kreisel
