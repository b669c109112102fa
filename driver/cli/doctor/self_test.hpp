// SPDX-License-Identifier: BSD-3-Clause
//
// Whether the program computes what it should: a few cells, of which the truth is known.
#pragma once

#include <vector>

#include "driver/cli/doctor/finding.hpp"
#include "driver/config/catalogue.hpp"

namespace kreisel {

/// The reference of the Lagrange top, whose uncertainty is its distance from the closed form too, and in each precision
/// the observed order of rkmk/rk4, log2(e_h/e_{h/2}), beside the declared one; with quad digits in quad. Of a
/// program without quad precision, the order in double against a run of finer steps.
std::vector<Finding> self_test(const Engines& engines);

}  // namespace kreisel
