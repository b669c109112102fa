// SPDX-License-Identifier: BSD-3-Clause
//
// A plan as text and as JSON.
#pragma once

#include <iosfwd>
#include <string>

#include "driver/plan/plan.hpp"

namespace kreisel {

/// "coordinates=exp dexpinv=exact".
std::string options_text(const OptionValues& options);

/// "24 cells: 20 to run, 4 skipped; 2 reference solutions".
std::string plan_summary(const Plan& plan);

/// A table of the cells, the reasons for skipped ones, and the summary.
void print_plan(const Plan& plan, std::ostream& out);

/// One JSON object: name, cells with their identity and skip reason, references, warnings.
void print_plan_json(const Plan& plan, std::ostream& out);

}  // namespace kreisel
