// SPDX-License-Identifier: BSD-3-Clause
//
// Projections at every k-th step: what drifts in between is small where k steps are short, and so is the cost.
#pragma once

#include <memory>

#include "methods/contract/projection.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The option `every`, k >= 1.
OptionDescription every_option();

/// The projection after each k-th step since `start`, of those that are not retracted; itself where k is 1.
std::unique_ptr<Projection> every_steps(long k, std::unique_ptr<Projection> projection);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
