// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/urdf/element.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "records/json/diagnostics.hpp"

namespace kreisel::urdf {

namespace {

// The number that a word is, whole and finite. XML schemata allow a plus sign, which from_chars does not.
std::optional<double> number_of(std::string_view word) {
    if (word.starts_with('+')) { word.remove_prefix(1); }
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool whole = error == std::errc() && end == word.data() + word.size();
    return whole && std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

}  // namespace

Complaints::Complaints(std::string file, const std::string& text) : file_(std::move(file)) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\n') { ends_.push_back(static_cast<std::ptrdiff_t>(i)); }
    }
}

int Complaints::line_at(std::ptrdiff_t offset) const {
    return 1 + static_cast<int>(std::lower_bound(ends_.begin(), ends_.end(), offset) - ends_.begin());
}

void Complaints::add(int line, const std::string& text) {
    errors_.push_back(fmt::format("{}:{}: {}", file_, line, text));
}

void Complaints::remark(const std::string& text) {
    const std::string whole = file_ + ": " + text;
    if (std::find(remarks_.begin(), remarks_.end(), whole) == remarks_.end()) { remarks_.push_back(whole); }
}

void Complaints::raise() const {
    if (!errors_.empty()) { throw Refusal(fmt::format("{}", fmt::join(errors_, "\n")), {{.rule = Rule::model}}); }
}

std::string Element::shown() const {
    return has("name") ? fmt::format("<{} {}>", tag(), in_quotes(value("name"))) : fmt::format("<{}>", tag());
}

std::vector<Element> Element::children() const {
    std::vector<Element> all;
    for (const pugi::xml_node& child : element_.children()) {
        if (child.type() == pugi::node_element) { all.emplace_back(child, *sink_); }
    }
    return all;
}

std::optional<Element> Element::child(const char* tag) const {
    const pugi::xml_node found = element_.child(tag);
    return found ? std::optional<Element>(Element(found, *sink_)) : std::nullopt;
}

std::optional<Element> Element::require(const char* tag) const {
    auto found = child(tag);
    if (!found) { error(fmt::format("expected an element <{}>, got none", tag)); }
    return found;
}

std::string Element::text(const char* attribute) const {
    if (!has(attribute)) {
        error(fmt::format("expected an attribute {}, got none", attribute));
        return "";
    }
    return value(attribute);
}

std::optional<std::vector<double>> Element::numbers(const char* attribute) const {
    std::vector<double> values;
    std::istringstream words(value(attribute));
    for (std::string word; words >> word;) {
        const auto value = number_of(word);
        if (!value) {
            error(fmt::format("expected numbers as {}, got {}", attribute, in_quotes(word)));
            return std::nullopt;
        }
        values.push_back(*value);
    }
    return values;
}

double Element::number(const char* attribute, double otherwise) const {
    return has(attribute) ? required_number(attribute) : otherwise;
}

double Element::required_number(const char* attribute) const {
    const auto value = number_of(text(attribute));
    if (!value && has(attribute)) {
        error(fmt::format("expected a number as {}, got {}", attribute, in_quotes(text(attribute))));
    }
    return value.value_or(0);
}

std::array<double, 3> Element::vector(const char* attribute, std::array<double, 3> otherwise) const {
    if (!has(attribute)) { return otherwise; }
    const auto values = numbers(attribute);
    if (values && values->size() == 3) { return {(*values)[0], (*values)[1], (*values)[2]}; }
    if (values) { error(fmt::format("expected three numbers as {}, got {}", attribute, in_quotes(value(attribute)))); }
    return otherwise;
}

}  // namespace kreisel::urdf
