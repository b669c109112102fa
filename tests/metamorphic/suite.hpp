// SPDX-License-Identifier: BSD-3-Clause
//
// The comparisons of a selection, one after another, with the objection to each.
#pragma once

#include <map>

#include "tests/metamorphic/exceptions.hpp"
#include "tests/metamorphic/judge.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

/// One constant for every comparison up to round-off: differences stay below C kappa N eps s.
inline constexpr int most_round_off = 100;

struct Report {
    std::map<std::string, int> compared;  ///< by class; problem x method x transformation each
    std::map<std::string, int> covered;   ///< comparisons that an exception covers, by its reason
    std::map<std::string, int> excepted;  ///< those of them that fail
    std::map<std::string, Real> largest;  ///< share of C kappa N eps s that was needed, by class
    std::vector<std::string> objections;
};

/// The objection to a case, or "".
std::string objection(const Case& entry, int steps, const Bench& bench, Report& report);

Report compare_all(const std::vector<Case>& cases, int steps, const Bench& bench = {});

/// Objections, at most a few dozen, and counts.
std::string to_text(const Report& report);

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
