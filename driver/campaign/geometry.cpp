// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/geometry.hpp"

#include <algorithm>

namespace kreisel {

std::vector<CellGeometry> geometries_of(const Plan& plan, const Engine& engine) {
    std::vector<CellGeometry> geometries;
    std::vector<const Cell*> firsts;
    for (const PlannedCell& planned : plan.cells) {
        const Cell& cell = planned.cell();
        if (cell.samples == 0 || !planned.skip_reason().empty()) { continue; }
        const auto same = [&](const Cell* other) {
            return other->problem == cell.problem && other->parameters == cell.parameters;
        };
        const auto known = std::find_if(firsts.begin(), firsts.end(), same);
        const auto index = static_cast<std::size_t>(known - firsts.begin());
        if (known == firsts.end()) {
            firsts.push_back(&cell);
            geometries.push_back({{}, engine.geometry(cell.problem, cell.parameters)});
        }
        geometries[index].cells.push_back(planned.hash());
    }
    return geometries;
}

void write_geometries(const Plan& plan, const Engine& engine, const std::filesystem::path& folder) {
    const std::vector<CellGeometry> geometries = geometries_of(plan, engine);
    if (!geometries.empty()) { write_geometry(folder, geometries); }
}

}  // namespace kreisel
