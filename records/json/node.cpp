// SPDX-License-Identifier: BSD-3-Clause
#include "records/json/node.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "records/json/exact.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

// Of ASCII.
bool is_control_character(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F;
}

// Code points of a text in UTF-8.
std::size_t characters_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

bool Node::require_object(const std::string& expected) const {
    if (!is_object()) { mismatch(expected); }
    return is_object();
}

void Node::only_keys(const std::vector<std::string>& known, const std::string& of) const {
    for (const auto& [key, value] : value_->items()) {
        if (std::find(known.begin(), known.end(), key) == known.end()) {
            sink_->add({pointer_below(pointer_, key), "one of the keys" + of + " " + listed(known),
                        "the key " + in_quotes(key), nearest_name(key, known), Target::key});
        }
    }
}

std::optional<Node> Node::find(const std::string& key) const {
    const auto found = value_->find(key);
    if (found == value_->end()) { return std::nullopt; }
    return Node(*found, pointer_below(pointer_, key), *sink_);
}

std::optional<Node> Node::require(const std::string& key, const std::string& expected) const {
    auto found = find(key);
    if (!found) { error("the key " + in_quotes(key) + ": " + expected, "nothing"); }
    return found;
}

std::optional<std::vector<Node>> Node::elements(const std::string& expected) const {
    if (!is_array() || value_->empty()) {
        mismatch(expected);
        return std::nullopt;
    }
    return elements_or_self();
}

std::vector<Node> Node::distinct_elements(const std::string& expected, const std::string& what) const {
    return distinct(elements(expected).value_or(std::vector<Node>()), what);
}

std::vector<Node> Node::elements_or_self() const {
    if (!is_array()) { return {*this}; }
    std::vector<Node> nodes;
    for (std::size_t i = 0; i < value_->size(); ++i) { nodes.push_back(element(i)); }
    return nodes;
}

std::optional<double> Node::number(const std::string& expected) const {
    if (!value_->is_number()) {
        mismatch(expected);
        return std::nullopt;
    }
    const auto value = value_->get<double>();
    if (!(std::abs(value) <= largest_number)) {
        mismatch(fmt::format("{} of at most {} in size", expected, largest_number));
        return std::nullopt;
    }
    return value + 0.0;  // -0 is written as an integer, which has no sign when it is read again
}

std::optional<double> Node::positive(const std::string& expected) const {
    const auto value = number(expected);
    if (value && !(*value >= least_positive)) {
        mismatch(*value > 0 ? fmt::format("{}, of at least {}", expected, least_positive) : expected);
        return std::nullopt;
    }
    return value;
}

std::optional<long> Node::count(long least, long most, const std::string& what) const {
    const std::string expected = fmt::format("{} (a whole number from {} to {})", what, least, most);
    const auto value = whole_number(*value_);
    if (!value || *value < least || *value > most) {
        mismatch(expected);
        return std::nullopt;
    }
    return value;
}

std::optional<bool> Node::flag() const {
    if (!value_->is_boolean()) {
        mismatch("true or false");
        return std::nullopt;
    }
    return value_->get<bool>();
}

std::optional<std::string> Node::text(const std::string& expected, std::size_t longest) const {
    if (!is_string()) {
        mismatch(expected);
        return std::nullopt;
    }
    const auto& text = value_->get_ref<const std::string&>();
    if (has_control_character(text)) {
        const bool ascii = std::any_of(text.begin(), text.end(), is_control_character);
        sink_->add({.pointer = pointer_,
                    .expected = expected + " without control characters",
                    .got = in_quotes(text),
                    .rule = ascii ? Rule::shape : Rule::separators});
        return std::nullopt;
    }
    const std::size_t characters = characters_of(text);
    if (characters == 0 || characters > longest) {
        error(fmt::format("{} of 1 to {} characters", expected, longest), fmt::format("{} characters", characters));
        return std::nullopt;
    }
    return text;
}

std::optional<std::string> Node::name(const std::string& what, const std::vector<std::string>& names) const {
    constexpr std::size_t most_listed = 40;  // more would hide the rest of the message
    const std::string expected = fmt::format(
        "{} ({})", what,
        names.size() <= most_listed ? listed(names) : fmt::format("one of {}, which kreisel list shows", names.size()));
    if (!is_string()) {
        mismatch(expected);
        return std::nullopt;
    }
    const auto& text = value_->get_ref<const std::string&>();
    if (std::find(names.begin(), names.end(), text) == names.end()) {
        mismatch(expected, nearest_name(text, names));
        return std::nullopt;
    }
    return text;
}

std::optional<long> whole_number(const nlohmann::json& value) {
    if (!value.is_number()) { return std::nullopt; }
    const auto number = value.get<double>();
    const bool is_whole = number == std::floor(number) && std::abs(number) <= largest_exact_whole;
    return is_whole ? std::optional(static_cast<long>(number)) : std::nullopt;
}

std::vector<Node> distinct(const std::vector<Node>& nodes, const std::string& what) {
    std::vector<Node> all;
    std::unordered_map<std::string, std::string> known;  // the pointer of each
    for (const Node& node : nodes) {
        const nlohmann::json& value = node.json();
        const auto [twin, is_new] =
            known.emplace(value.is_number() ? fmt::format("{}", value.get<double>()) : value.dump(), node.pointer());
        if (is_new) {
            all.push_back(node);
        } else if (value.is_structured()) {
            node.error("each " + what + " once", "the same as at " + twin->second);
        } else {
            node.error("each " + what + " once", node.shown() + " again");
        }
    }
    return all;
}

bool has_control_character(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : '\0');
        if (is_control_character(text[i]) || (byte == 0xC2 && next >= 0x80 && next <= 0x9F)) { return true; }
    }
    // U+2028 and U+2029, the line and paragraph separators
    return text.find("\xE2\x80\xA8") != std::string_view::npos || text.find("\xE2\x80\xA9") != std::string_view::npos;
}

}  // namespace kreisel
