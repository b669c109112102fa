// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/certify/trials.hpp"

#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "driver/campaign/campaign.hpp"
#include "driver/config/composition/composed.hpp"
#include "driver/config/shipped.hpp"
#include "records/json/strict.hpp"
#include "records/provenance.hpp"
#include "records/reading/read_results.hpp"
#include "records/reference_store.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

constexpr int highest_order_in_double = 4;

void lengthen(nlohmann::json& time, int times) {
    time["end"] = time["end"].get<double>() * times;
    for (nlohmann::json& steps : time["steps"]) { steps = steps.get<long>() * times; }
}

Document config_of_trial(const std::string& name, const MethodDescription& method, int times) {
    Document document = composed_config(config_file(name));
    nlohmann::json& config = document.value;
    config["methods"] = {method.name};
    const bool is_free = !config.contains("precision");
    if (is_free && method.order.configuration > highest_order_in_double) { config["precision"] = "quad"; }
    if (times > 1) { lengthen(config["time"], times); }
    if (method.own_control) {
        config["precision"] = "double";
        config["time"].erase("steps");
        config["time"]["tolerance"] = {{"from", 1e-3}, {"levels", 8}};
    }
    return parse_document(document.file, config.dump(2));
}

RunSettings trial_settings() {
    RunSettings settings;
    settings.workers = usual_workers();
    settings.build = build_id();
    settings.cache = default_cache_folder();
    settings.terminal = isatty(STDERR_FILENO) != 0;
    return settings;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "kreisel_XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr) { throw FileError(pattern + ": cannot be made"); }
    path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;  // what is left behind does no harm
    std::filesystem::remove_all(path_, ignored);
}

void run_plan(const Plan& plan, const std::filesystem::path& folder, const Engines& engines, std::ostream& messages) {
    if (run_campaign(plan, engines, folder, trial_settings(), messages).interrupted) { throw TrialInterrupted(); }
}

Results run_trial(const std::string& name, const MethodDescription& method, int times,
                  const std::filesystem::path& folder, const Engines& engines, std::ostream& messages) {
    const Plan plan = plan_of(config_of_trial(name, method, times), engines);
    run_plan(plan, folder / name, engines, messages);
    return read_results(folder / name);
}

}  // namespace kreisel
