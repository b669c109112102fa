// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/geometry.hpp"

#include <map>
#include <string>

namespace kreisel {

std::vector<CellGeometry> geometries_of(const Plan& plan, const Engine& engine) {
    std::vector<CellGeometry> geometries;
    std::map<std::string, std::size_t> known;  // by name and parameters of a problem
    for (const PlannedCell& planned : plan.cells) {
        if (planned.run->cell.samples == 0 || !planned.skip_reason().empty()) { continue; }
        const ProblemPoint problem = planned.problem();
        const auto [place, is_new] = known.emplace(problem.name() + " " + problem.parameters_text(), geometries.size());
        if (is_new) {
            Geometry geometry = engine.geometry(problem.name(), problem.parameters());
            geometries.push_back({{}, std::move(geometry), problem.series()->shapes()});
        }
        geometries[place->second].cells.push_back(planned.hash());
    }
    return geometries;
}

void write_geometries(const Plan& plan, const Engine& engine, const std::filesystem::path& folder) {
    const std::vector<CellGeometry> geometries = geometries_of(plan, engine);
    if (!geometries.empty()) { write_geometry(folder, geometries); }
}

}  // namespace kreisel
