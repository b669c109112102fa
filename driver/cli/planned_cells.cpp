// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/planned_cells.hpp"

#include "driver/plan/plan.hpp"
#include "records/manifest.hpp"
#include "support/errors.hpp"

namespace kreisel {

std::vector<CellIdentity> planned_cells(const std::filesystem::path& folder, const Engines& engines) {
    std::vector<CellIdentity> cells;
    try {
        const ManifestContents manifest = read_manifest(manifest_file(folder, ""));
        for (const PlannedCell& planned : plan_of(manifest.config, engines).cells) {
            cells.push_back(planned.identity());
        }
    } catch (const UsageError&) {  // another version's config
        return {};
    } catch (const FileError&) {  // no manifest, or a damaged one, which the command names with the other damage
        return {};
    }
    return cells;
}

}  // namespace kreisel
