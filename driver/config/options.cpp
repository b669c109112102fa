// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "driver/config/catalogue.hpp"
#include "driver/config/reading/text_options.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

bool takes_counts(const OptionDescription& option) { return option.count_max >= option.count_min; }

bool takes_reals(const OptionDescription& option) { return option.real_max >= option.real_min; }

bool takes_flags(const OptionDescription& option) { return std::holds_alternative<bool>(option.standard); }

std::optional<OptionValue> read_number(const Node& node, const OptionDescription& option) {
    const auto whole = whole_number(node.json());
    if (takes_counts(option) && (whole || !takes_reals(option))) {
        if (whole && *whole >= option.count_min && *whole <= option.count_max) { return *whole; }
        node.mismatch(expectation(option));
        return std::nullopt;
    }
    const double number = node.json().get<double>();
    if (takes_reals(option) && number >= option.real_min && number <= option.real_max) { return number; }
    node.mismatch(expectation(option));
    return std::nullopt;
}

std::optional<OptionValue> read_value(const Node& node, const OptionDescription& option) {
    const nlohmann::json& value = node.json();
    if (value.is_number() && (takes_counts(option) || takes_reals(option))) { return read_number(node, option); }
    if (value.is_boolean() && takes_flags(option)) { return value.get<bool>(); }
    if (value.is_string()) {
        const auto& word = value.get_ref<const std::string&>();
        if (std::find(option.choices.begin(), option.choices.end(), word) != option.choices.end()) { return word; }
        node.mismatch(expectation(option), nearest_name(word, option.choices));
        return std::nullopt;
    }
    node.mismatch(expectation(option));
    return std::nullopt;
}

std::vector<OptionValue> read_axis(const Node& node, const OptionDescription& option) {
    if (option.text != OptionText::none) {
        const auto text = read_text_option(node, option);
        return text ? std::vector<OptionValue>{*text} : std::vector<OptionValue>();
    }
    std::vector<OptionValue> values;
    for (const Node& entry :
         node.is_array() ? node.distinct_elements(expectation(option), "value") : std::vector<Node>{node}) {
        if (const auto value = read_value(entry, option)) { values.push_back(*value); }
    }
    return values;
}

std::vector<OptionValues> crossed(const std::vector<OptionValues>& combinations, const std::string& name,
                                  const std::vector<OptionValue>& values) {
    std::vector<OptionValues> result;
    for (const OptionValues& combination : combinations) {
        for (const OptionValue& value : values) {
            result.push_back(combination);
            result.back()[name] = value;
        }
    }
    return result;
}

}  // namespace

std::string allowed_values(const OptionDescription& option) {
    std::vector<std::string> parts;
    if (!option.choices.empty()) { parts.push_back("one of " + listed(option.choices)); }
    if (takes_counts(option)) {
        parts.push_back(fmt::format("a whole number from {} to {}", option.count_min, option.count_max));
    }
    if (takes_flags(option)) { parts.emplace_back("true or false"); }
    if (takes_reals(option)) {
        parts.push_back(fmt::format("a number from {} to {}", option.real_min, option.real_max));
    }
    if (option.text != OptionText::none) { parts.push_back(allowed_text(option.text)); }
    return fmt::format("{}", fmt::join(parts, ", or "));
}

std::string expectation(const OptionDescription& option) {
    return allowed_values(option) + " for the option " + in_quotes(option.name);
}

std::vector<OptionValues> default_options(const std::vector<OptionDescription>& options) {
    return {with_defaults({}, options)};
}

std::vector<OptionValues> read_options(const Node& written, const std::vector<OptionDescription>& options) {
    std::vector<std::string> keys = names_of(options);
    keys.insert(keys.begin(), "name");
    written.only_keys(keys);
    std::vector<OptionValues> combinations = {{}};
    for (const OptionDescription& option : options) {
        const auto node = written.find(option.name);
        combinations = crossed(combinations, option.name,
                               node ? read_axis(*node, option) : std::vector<OptionValue>{option.standard});
    }
    return combinations;
}

}  // namespace kreisel
