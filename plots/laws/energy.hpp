// SPDX-License-Identifier: BSD-3-Clause
//
// Whether the energy errors of a method stay bounded or grow, from the samples of runs with different steps.
#pragma once

#include <filesystem>
#include <optional>

#include "plots/tables/names.hpp"
#include "records/fits/energy.hpp"

namespace kreisel {

/// E - E_0 of a cell, with |E_0| from its relative metric; nothing unless it is ok, has steps of one size, at least 65
/// samples, and the metric invariant.energy.
std::optional<EnergySeries> energy_series(const ResultRow& row);

/// The law of the cells of a group that have a series; nothing where fewer than two have.
std::optional<EnergyLaw> energy_law_of(const CellGroup& group);

}  // namespace kreisel
