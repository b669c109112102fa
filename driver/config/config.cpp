// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/config.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "driver/config/keys/keys.hpp"
#include "driver/config/reading/measurements.hpp"
#include "driver/config/reading/methods.hpp"
#include "driver/config/reading/problems.hpp"
#include "driver/config/time.hpp"
#include "records/json/node.hpp"
#include "records/kinds/kind.hpp"

namespace kreisel {

namespace {

// A file name on every system: no separator, no leading dot or dash.
bool is_plain_name(const std::string& name) {
    const auto plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
               c == '.';
    };
    return std::all_of(name.begin(), name.end(), plain) && name.front() != '.' && name.front() != '-';
}

void read_name(const Node& root, Config& config) {
    const std::string& expected = find_named(config_keys(), "name")->missing;
    const auto node = find_key(root, config_keys(), "name");
    const auto name = node ? node->text(expected, 100) : std::nullopt;
    if (name && !is_plain_name(*name)) { node->mismatch(expected); }
    config.name = name.value_or("");
}

std::vector<std::string> read_names(const Node& root, const std::string& key, const std::string& what,
                                    const std::vector<std::string>& names, const std::vector<std::string>& standard) {
    const auto node = find_key(root, config_keys(), key);
    if (!node) { return standard; }
    std::vector<std::string> result;
    for (const Node& entry : node->distinct_elements("a list of at least one " + what, what)) {
        if (const auto name = entry.name("a " + what, names)) { result.push_back(*name); }
    }
    return result;
}

// Only "precision" may also be a bare string.
std::vector<std::string> read_precisions(const Node& root) {
    const std::vector<std::string>& names = precision_kind().names;
    const auto node = find_key(root, config_keys(), "precision");
    if (node && node->is_array()) { return read_names(root, "precision", "precision", names, {}); }
    if (!node) { return {"double"}; }
    const auto name = node->name(precision_kind().what + " or a list of them", names);
    return name ? std::vector<std::string>{*name} : std::vector<std::string>();
}

}  // namespace

bool Config::is_timed() const {
    const ExperimentKind* known = find_experiment_kind(kind);
    return known != nullptr && known->timed;
}

bool Config::is_repeated() const {
    const ExperimentKind* known = find_experiment_kind(kind);
    return known != nullptr && known->repeated;
}

Config read_config(const Document& document, const Catalogue& catalogue) {
    Diagnostics sink(document);
    const Node root(document.value, "", sink);
    const std::vector<std::string> keys = names_of(config_keys());
    Config config;
    if (!root.require_object("a config: an object with the keys " + listed(keys))) { sink.raise(); }
    root.only_keys(keys);
    read_name(root, config);
    config.description = read_key(root, config_keys(), "description", description_kind()).value_or("");
    config.kind = read_key(root, config_keys(), "kind", kind_of_experiment()).value_or("");
    config.precisions = read_precisions(root);
    read_problems(root, catalogue, config);
    config.formulations = read_names(root, "formulations", "formulation", names_of(catalogue.formulations), {"SO3xR3"});
    read_methods(root, catalogue, config);
    if (const auto time = find_key(root, config_keys(), "time")) { read_time(*time, config); }
    read_measurements(root, catalogue, config);
    sink.raise();
    config.warnings = document.remarks;
    config.warnings.insert(config.warnings.end(), sink.warnings().begin(), sink.warnings().end());
    return config;
}

}  // namespace kreisel
