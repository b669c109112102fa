// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/reading/methods.hpp"

#include <algorithm>

#include "driver/config/keys/keys.hpp"
#include "driver/config/options.hpp"
#include "driver/config/reading/entries.hpp"

namespace kreisel {

namespace {

template <class Description>
void add_optioned(const Node& entry, const std::string& what, const Description& description,
                  std::vector<OptionedEntry>& result) {
    const auto combinations =
        entry.is_object() ? read_options(entry, description.options) : default_options(description.options);
    for (const OptionValues& options : combinations) {
        const auto twin = std::find_if(result.begin(), result.end(), [&](const OptionedEntry& other) {
            return other.name == description.name && other.options == options;
        });
        if (twin != result.end()) {
            entry.violates(Rule::each_once, "each " + what + " once", "the same as at " + twin->pointer);
        } else {
            result.push_back({description.name, options, entry.pointer()});
        }
    }
}

template <class Description>
std::vector<OptionedEntry> read_optioned(const Node& list, const std::string& what,
                                         const std::vector<Description>& known) {
    std::vector<OptionedEntry> result;
    for (const Node& entry : list.distinct_elements("a list of at least one " + what, what)) {
        for (const Description* description : described_by(entry, what, known)) {
            add_optioned(entry, what, *description, result);
        }
    }
    return result;
}

}  // namespace

void read_methods(const Node& root, const Catalogue& catalogue, Config& config) {
    if (const auto node = find_key(root, config_keys(), "methods")) {
        config.methods = read_optioned(*node, "method", catalogue.methods);
    }
    if (const auto node = find_key(root, config_keys(), "projections")) {
        config.projections = read_optioned(*node, "projection", catalogue.projections);
    } else if (const auto* none = find_named(catalogue.projections, "none")) {
        config.projections = {{none->name, default_options(none->options).front(), ""}};
    }
}

}  // namespace kreisel
