// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/catalogue/configs.hpp"

#include <nlohmann/json.hpp>
#include <vector>

#include "driver/cli/catalogue/rows.hpp"
#include "driver/config/composition/composed.hpp"
#include "driver/config/shipped.hpp"
#include "records/json/diagnostics.hpp"

namespace kreisel {

void list_configs(std::ostream& out) {
    std::vector<NamedText> rows;
    for (const auto& [name, file] : configs_below(shipped_folder())) {
        rows.emplace_back(name, composed_config(file).value.value("description", ""));
    }
    print_rows(out, "Configs, which `run` finds by name", rows);
}

}  // namespace kreisel
