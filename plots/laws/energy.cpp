// SPDX-License-Identifier: BSD-3-Clause
#include "plots/laws/energy.hpp"

#include "records/reading/trajectory_table.hpp"

namespace kreisel {

namespace {

const std::string energy_metric = "invariant.energy";

double value_or_zero(const ResultRow& row, const std::string& name) {
    const auto found = row.metrics.find(name);
    return found == row.metrics.end() ? 0 : found->second;
}

}  // namespace

std::optional<EnergySeries> energy_series(const ResultRow& row) {
    if (!row.ok() || row.adaptive() || !row.has_trajectory || !row.metrics.contains(energy_metric)) {
        return std::nullopt;
    }
    const TrajectoryTable trajectory = read_trajectory(row);
    const auto *t = trajectory.find("t"), *drift = trajectory.find(energy_metric);
    if (t == nullptr || drift == nullptr || t->size() < least_energy_samples) { return std::nullopt; }
    const double largest = value_or_zero(row, energy_metric);
    const double relative = value_or_zero(row, energy_metric + ".relative");
    return EnergySeries{row.h, *t, *drift, largest, relative > 0 ? largest / relative : 0};
}

std::optional<EnergyLaw> energy_law_of(const CellGroup& group) {
    std::vector<EnergySeries> runs;
    for (const ResultRow* row : group.rows) {
        if (auto series = energy_series(*row)) { runs.push_back(std::move(*series)); }
    }
    return runs.size() < 2 ? std::nullopt : std::optional(energy_law(std::move(runs)));
}

}  // namespace kreisel
