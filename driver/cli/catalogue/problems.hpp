// SPDX-License-Identifier: BSD-3-Clause
//
// What `kreisel info` says of a problem.
#pragma once

#include <iosfwd>

#include "engine/engine.hpp"

namespace kreisel {

/// Its parameters, the keys of its parts, and what it leads to in each formulation.
void describe_problem(const Engine& engine, const ProblemDescription& problem, std::ostream& out);

}  // namespace kreisel
