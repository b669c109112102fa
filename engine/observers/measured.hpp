// SPDX-License-Identifier: BSD-3-Clause
//
// Collects the values of requested metrics.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "engine/report/report.hpp"
#include "support/pattern.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using MeasuredMetrics = std::vector<std::pair<std::string, Number>>;

/// Adds a value whose name one of the patterns fits.
inline void add_value(MeasuredMetrics& all, const std::vector<std::string>& patterns, const std::string& name,
                      const Real& value) {
    if (matches_any(patterns, name)) all.emplace_back(name, to_number(value));
}

/// The same, if it is finite.
inline void add_measured(MeasuredMetrics& all, const std::vector<std::string>& patterns, const std::string& name,
                         const Real& value) {
    if (isfinite(value)) add_value(all, patterns, name, value);
}

/// worst = max(worst, now), in which NaN and infinity persist.
inline void keep_worst(Real& worst, const Real& now) {
    if (isfinite(worst) && !(now <= worst)) worst = now;
}

/// Whether one of the patterns fits the name with one of the suffixes.
template <std::size_t n>
bool any_matches(const std::vector<std::string>& patterns, const std::string& name, const char* const (&suffixes)[n]) {
    for (const char* suffix : suffixes)
        if (matches_any(patterns, name + suffix)) return true;
    return false;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
