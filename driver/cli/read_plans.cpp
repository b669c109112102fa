// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/read_plans.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "driver/config/composition/composed.hpp"
#include "driver/config/composition/filter.hpp"
#include "driver/config/shipped.hpp"

namespace kreisel {

namespace {

void print_warnings(const Plan& plan, const std::string& file, std::ostream& messages) {
    for (const std::string& warning : plan.warnings) { fmt::print(messages, "{}: warning: {}\n", file, warning); }
}

}  // namespace

Paths config_files(const Paths& written) {
    Paths files;
    std::string errors;
    for (const auto& one : written) {
        try {
            files.push_back(config_file(one));
        } catch (const UsageError& error) { errors += (errors.empty() ? "" : "\n") + std::string(error.what()); }
    }
    if (!errors.empty()) { throw UsageError(errors); }
    return files;
}

std::vector<Plan> read_plans(const Paths& files, const ConfigChanges& changes, const Engines& engines,
                             std::ostream& messages) {
    const Catalogue catalogue(engines.binary64);
    std::vector<Plan> plans;
    std::string errors;
    for (const auto& file : files) {
        try {
            const Document document = composed_config(file, changes.settings);
            Config config = read_config(document, catalogue);
            apply_filters(changes.filters, config);
            plans.push_back(make_plan(document, config, engines));
            print_warnings(plans.back(), file.string(), messages);
        } catch (const UsageError& error) { errors += (errors.empty() ? "" : "\n") + std::string(error.what()); }
    }
    if (!errors.empty()) { throw UsageError(errors); }
    return plans;
}

}  // namespace kreisel
