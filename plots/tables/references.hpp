// SPDX-License-Identifier: BSD-3-Clause
//
// How far the references of a convergence study can be trusted.
#pragma once

#include "plots/tables/text.hpp"
#include "records/results.hpp"

namespace kreisel {

/// One row per problem (by label) and end time: the horizon, and for each quantity the digits up to which step sizes
/// and routes agree, -log10 of the error bound relative to the size of the final state.
TextTable references_table(const Results& results);

}  // namespace kreisel
