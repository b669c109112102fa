// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/suggestions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "driver/cli/catalogue.hpp"
#include "records/json/diagnostics.hpp"
#include "support/errors.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

std::vector<std::string> command_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(sub->get_name());
    }
    return names;
}

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) { names.push_back("--" + name); }
    }
    return names;
}

}  // namespace

std::string suggestion(const CLI::App& app, const std::vector<std::string>& words) {
    const CLI::App* sub = nullptr;
    for (const std::string& word : words) {
        std::vector<std::string> names;
        if (word.starts_with("--")) {
            names = option_names(sub == nullptr ? app : *sub);
        } else if (sub == nullptr) {
            names = command_names(app);
            const auto subs = app.get_subcommands([&](const CLI::App* one) { return one->get_name() == word; });
            sub = subs.empty() ? nullptr : subs.front();
        } else if (sub->get_name() == "list") {
            names = catalogue_topics();
        }
        const std::string typed = word.substr(0, word.find('='));
        const std::string nearest = nearest_name(typed, names);
        if (!nearest.empty() && nearest != typed) { return "; did you mean " + in_quotes(nearest) + "?"; }
    }
    return "";
}

void require_command(const CLI::App& app, const std::string& word) {
    const auto names = command_names(app);
    if (std::find(names.begin(), names.end(), word) != names.end()) { return; }
    const std::string nearest = nearest_name(word, names);
    throw UsageError(fmt::format("expected a command ({}), got {}{}\nRun with --help for more information.",
                                 listed(names), in_quotes(word),
                                 nearest.empty() ? "" : "; did you mean " + in_quotes(nearest) + "?"));
}

}  // namespace kreisel
