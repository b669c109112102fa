// SPDX-License-Identifier: BSD-3-Clause
//
// What errors are measured from: two states of one system at one time.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/report/joint_forces.hpp"
#include "engine/report/report.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Distances of bodies and multipliers; NaN for what is not known. Differences of two routes of a reference have the
/// same form.
struct Separation {
    Distance states;
    MultiplierDistance multipliers = unknown_multipliers();
    static MultiplierDistance unknown_multipliers();
};

/// A state, a reference, and how far apart they are.
struct Comparison {
    const std::vector<BodyState>&states, &reference;
    Separation apart;
};

/// The separation by error metric, as far as it is finite and the system has rows of the metric's kind.
std::map<std::string, Number> errors_of(const Separation& apart, const std::vector<ConstraintRow>& rows);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
