// SPDX-License-Identifier: BSD-3-Clause
//
// Shared by the campaign suites: default parameters and options.
#pragma once

#include <string>
#include <vector>

#include "engine/engine.hpp"
#include "tests/support/order_rule.hpp"

namespace kreisel::acceptance {

inline ParameterValues defaults(const std::string& problem) {
    for (const ProblemDescription& description : engine_binary64().problems())
        if (description.name == problem) return demonstration_parameters(description);
    return {};
}

/// All samples of a run.
struct Samples final : SampleSink {
    void begin(const std::vector<Column>& all) override { columns = all; }
    void add(const std::string& row) override { rows.push_back(row); }

    std::vector<Column> columns;
    std::vector<std::string> rows;
};

inline OptionValues standard_options(const MethodDescription& method) { return with_defaults({}, method.options); }

/// The default options, and each word and the least value of each real in turn; counts and flags stay at their default.
inline std::vector<OptionValues> variants(const MethodDescription& method) {
    const OptionValues standard = standard_options(method);
    std::vector<OptionValues> all = {standard};
    const auto vary = [&](const std::string& option, const OptionValue& value) {
        if (value == standard.at(option)) return;
        all.push_back(standard);
        all.back()[option] = value;
    };
    for (const OptionDescription& option : method.options) {
        for (const std::string& word : option.choices) vary(option.name, word);
        if (option.real_min <= option.real_max) vary(option.name, option.real_min);
    }
    return all;
}

}  // namespace kreisel::acceptance
