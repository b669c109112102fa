// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/estimate/estimate.hpp"

#include <fmt/format.h>

#include "driver/plan/estimate/amounts.hpp"

namespace kreisel {

namespace {

// Fitted to the files and the peak memory of runs of 20 to 1000 cells: heavy_top with and without metrics and samples,
// chains of 16 and 64 links.
constexpr double line_bytes = 550, body_bytes = 890, metrics_bytes = 1100;  // of a line of results.jsonl
constexpr double lines = 2, table = 0.5;  // journal and results.jsonl; a row of results.csv beside a line
constexpr int most_bodies = 16;           // of which results.csv has the states
constexpr double number_bytes = 19;       // of samples
constexpr double quad_digits = 2;         // how much longer numbers are
constexpr double program_bytes = 45e6;    // of the program and a worker
constexpr double cell_memory = 150;       // of a cell: in the plan, in the queue, and where its line is
constexpr double skipped_bytes = 500;

double line_of(const PlannedCell& planned, const SystemSummary& system) {
    if (!planned.skip_reason().empty()) { return skipped_bytes; }
    const double numbers = body_bytes * system.bodies + (planned.run->cell.metrics.empty() ? 0 : metrics_bytes);
    return line_bytes + numbers * (planned.quad() ? quad_digits : 1);
}

// Time, bodies with 18 numbers each, multipliers, reactions with six numbers for some three rows each; metrics.
double samples_of(const PlannedCell& planned, const SystemSummary& system) {
    const Cell& cell = planned.run->cell;
    if (cell.samples == 0 || !planned.skip_reason().empty()) { return 0; }
    const double columns = 1 + 18 * system.bodies + 3 * system.constraints.rows + (cell.metrics.empty() ? 0 : 14);
    return static_cast<double>(cell.samples + 1) * columns * number_bytes * (planned.quad() ? quad_digits : 1);
}

}  // namespace

Estimate estimate_of(const Plan& plan) {
    Estimate estimate{0, program_bytes, 0};
    for (const auto& [hash, reference] : plan.references) { estimate.seconds += reference.weight; }
    for (const PlannedCell& planned : plan.cells) {
        const SystemSummary& system = *planned.run->system;
        const double line = line_of(planned, system);
        estimate.seconds += planned.weight;
        estimate.memory += cell_memory;
        estimate.disk += line * (lines + (system.bodies <= most_bodies ? table : 0)) + samples_of(planned, system);
    }
    return estimate;
}

std::string estimate_text(const Estimate& estimate) {
    return fmt::format("about {} of CPU time, {} of memory, {} on disk", duration_text(estimate.seconds),
                       size_text(estimate.memory), size_text(estimate.disk));
}

}  // namespace kreisel
