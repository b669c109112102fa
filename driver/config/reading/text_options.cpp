// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/reading/text_options.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "driver/config/options.hpp"

namespace kreisel {

namespace {

constexpr const char* an_exact_number = "a whole number, or a fraction or decimal in quotes (\"-25/108\", \"0.25\")";

bool is_exact_number(std::string_view text) {
    const auto skip_digits = [&] {
        const auto end = std::min(text.find_first_not_of("0123456789"), text.size());
        text.remove_prefix(end);
        return end > 0;
    };
    if (text.starts_with('-')) { text.remove_prefix(1); }
    if (!skip_digits()) { return false; }
    if (text.empty()) { return true; }
    const bool marked = text.front() == '/' || text.front() == '.';
    text.remove_prefix(1);
    return marked && skip_digits() && text.empty();
}

// Several texts as one, apart by `between`; nothing if one of them could not be read.
class Joined {
  public:
    explicit Joined(std::string between) : between_(std::move(between)) {}
    void add(const std::optional<std::string>& part) {
        complete_ = complete_ && part;
        text_ += (first_ ? "" : between_) + part.value_or("");
        first_ = false;
    }
    std::optional<std::string> text() const { return complete_ ? std::optional(text_) : std::nullopt; }

  private:
    std::string between_, text_;
    bool first_ = true, complete_ = true;
};

std::optional<std::string> read_number_entry(const Node& node) {
    if (node.json().is_number_integer()) { return node.json().dump(); }
    if (const auto whole = whole_number(node.json())) { return std::to_string(*whole); }
    if (node.is_string() && is_exact_number(node.json().get_ref<const std::string&>())) {
        return node.json().get<std::string>();
    }
    node.mismatch(an_exact_number);
    return std::nullopt;
}

std::optional<std::string> read_number_row(const Node& node) {
    if (!node.is_array()) {
        node.mismatch("a row, a list of numbers");
        return std::nullopt;
    }
    Joined row(" ");
    for (const Node& entry : node.elements_or_self()) { row.add(read_number_entry(entry)); }
    return row.text();
}

// A row written as a text.
std::optional<std::string> joined_number_words(const std::string& text) {
    Joined row(" ");
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ' ');) {
        if (!word.empty()) { row.add(is_exact_number(word) ? std::optional(word) : std::nullopt); }
    }
    return row.text();
}

std::optional<std::string> joined_number_rows(const std::string& text) {
    Joined rows("; ");
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
        end = text.find(';', begin);
        rows.add(joined_number_words(text.substr(begin, end - begin)));
    }
    return rows.text();
}

std::optional<std::string> read_number_list(const Node& node, const OptionDescription& option) {
    const bool rows = option.text == OptionText::rows;
    const auto entries = node.elements(expectation(option));
    if (!entries) { return std::nullopt; }
    Joined all(rows ? "; " : " ");
    for (const Node& entry : *entries) { all.add(rows ? read_number_row(entry) : read_number_entry(entry)); }
    return all.text();
}

std::optional<std::string> read_option_label(const Node& node) {
    if (node.is_string() && node.json().get_ref<const std::string&>().empty()) { return ""; }
    const auto label = node.text("a label", longest_option_label);
    // Spreadsheets read a cell with such a first character as a formula.
    if (label && std::string_view("=+-@").find(label->front()) != std::string_view::npos) {
        node.mismatch("a label that does not begin with '=', '+', '-' or '@'");
        return std::nullopt;
    }
    return label;
}

}  // namespace

std::string allowed_text(OptionText text) {
    if (text == OptionText::label) { return "a text"; }
    const std::string exact = "whole numbers, fractions and decimals";
    if (text == OptionText::rows) { return "rows of " + exact + R"(, as [["1/2"], [0, "0.5"]] or "1/2; 0 0.5")"; }
    return exact + R"(, as ["1/2", "0.5", 0] or "1/2 0.5 0")";
}

std::optional<std::string> read_text_option(const Node& node, const OptionDescription& option) {
    if (option.text == OptionText::label) { return read_option_label(node); }
    if (node.is_array()) { return read_number_list(node, option); }
    std::optional<std::string> text;
    if (node.is_string()) {
        const auto& written = node.json().get_ref<const std::string&>();
        text = option.text == OptionText::rows ? joined_number_rows(written) : joined_number_words(written);
    }
    if (!text) { node.mismatch(expectation(option)); }
    return text;
}

}  // namespace kreisel
