// SPDX-License-Identifier: BSD-3-Clause
//
// Runs one cell.
#pragma once

#include "engine/engine.hpp"
#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// `reference` and `samples` may be null: no errors are measured, samples are dropped.
Outcome run_cell(const Cell& cell, const Reference* reference, const Watch& watch, SampleSink* samples = nullptr);

/// Engine::run_time.
std::optional<double> time_cell(const Cell& cell, const Watch& watch);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
