// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/schema/text_option.hpp"

#include <nlohmann/json.hpp>

#include "driver/config/reading/text_options.hpp"

namespace kreisel::schema {

namespace {

const std::string number_pattern = "-?[0-9]+([./][0-9]+)?";
const std::string numbers_pattern = " *(" + number_pattern + "( +" + number_pattern + ")*)? *";

Schema fitting(const std::string& pattern) { return {{"type", "string"}, {"pattern", "^" + pattern + "$"}}; }

Schema number_entry() { return {{"anyOf", {{{"type", "integer"}}, fitting(number_pattern)}}}; }

Schema option_label() {
    Schema label = text(longest_option_label);
    label["minLength"] = 0;
    label["not"] = {{"pattern", "^[=+@-]"}};
    return label;
}

}  // namespace

Schema text_option(OptionText text) {
    if (text == OptionText::label) { return option_label(); }
    if (text == OptionText::numbers) { return {{"anyOf", {list(number_entry()), fitting(numbers_pattern)}}}; }
    return {{"anyOf", {list(list(number_entry(), 0)), fitting(numbers_pattern + "(;" + numbers_pattern + ")*")}}};
}

}  // namespace kreisel::schema
