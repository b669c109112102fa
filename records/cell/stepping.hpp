// SPDX-License-Identifier: BSD-3-Clause
//
// How messages name the steps of a cell.
#pragma once

#include <fmt/format.h>

#include <string>

namespace kreisel {

/// "1000 steps", or "tolerance 1e-06".
template <class Stepped>
std::string stepping_text(const Stepped& cell) {
    return cell.tolerance > 0 ? fmt::format("tolerance {}", cell.tolerance) : fmt::format("{} steps", cell.steps);
}

}  // namespace kreisel
