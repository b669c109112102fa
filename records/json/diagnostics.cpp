// SPDX-License-Identifier: BSD-3-Clause
#include "records/json/diagnostics.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "records/json/node.hpp"

namespace kreisel {

namespace {

constexpr std::size_t longest_quote = 60;
constexpr std::size_t most_messages = 20;
constexpr std::size_t most_places = 1000;  // issues whose order in the text is found, each by a walk through it

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

std::string cut(std::string_view text) {
    if (text.size() <= longest_quote) { return std::string(text); }
    std::size_t end = longest_quote;
    while (end > 0 && continues_character(text[end])) { --end; }
    return std::string(text.substr(0, end)) + "...";
}

// Control characters beyond ASCII, which a terminal may obey, make all that is not ASCII appear as \\u....
std::string escaped(std::string_view text) {
    const std::string dumped =
        nlohmann::json(std::string(text))
            .dump(-1, ' ', has_control_character(text), nlohmann::json::error_handler_t::replace);
    return dumped.substr(1, dumped.size() - 2);
}

// The pointer as printed in a message: a key may hold any character, even a newline.
std::string shown_pointer(const std::string& pointer) {
    return pointer.empty() ? "/" : escaped(pointer.size() > 400 ? pointer.substr(0, 400) + "..." : pointer);
}

std::string number_text(const Document& document, const std::string& pointer) {
    const std::size_t start = locate(document.text, pointer);
    const std::size_t end = document.text.find_first_of(",]} \t\r\n", start);
    return cut(std::string_view(document.text).substr(start, end == std::string::npos ? end : end - start));
}

// The layer that wrote what is at `pointer`, and the pointer there; the document itself if no layer has it.
std::pair<const Document*, std::string> source_of(const Document& document, const std::string& pointer) {
    for (auto layer = document.layers.rbegin(); layer != document.layers.rend(); ++layer) {
        const std::string& top = layer->pointer;
        const bool below = pointer.starts_with(top) && (pointer.size() == top.size() || pointer[top.size()] == '/');
        if (!below) { continue; }
        std::string rest = pointer.substr(top.size());
        if (layer->source->value.contains(nlohmann::json::json_pointer(rest))) {
            return {layer->source.get(), std::move(rest)};
        }
    }
    return {&document, pointer};
}

}  // namespace

const Document& writer_of(const Document& document, const std::string& pointer) {
    return *source_of(document, pointer).first;
}

std::vector<Layer> layers_of(const Document& document) {
    if (!document.layers.empty()) { return document.layers; }
    return {{"", std::make_shared<const Document>(document)}};
}

std::filesystem::path folder_of(const Document& document, const std::string& pointer) {
    const Document& writer = writer_of(document, pointer);
    return std::filesystem::path(writer.file.starts_with("--set ") ? document.file : writer.file).parent_path();
}

std::string in_quotes(std::string_view text) { return "\"" + escaped(cut(text)) + "\""; }

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) { text += (text.empty() ? "" : ", ") + in_quotes(name); }
    return text;
}

std::string shown(const Document& document, const nlohmann::json& value, const std::string& pointer) {
    switch (value.type()) {
        case nlohmann::json::value_t::string:
            return in_quotes(value.get_ref<const std::string&>());
        case nlohmann::json::value_t::array:
            return value.empty() ? "an empty list" : fmt::format("a list of {}", value.size());
        case nlohmann::json::value_t::object:
            return value.empty() ? "an empty object" : "an object";
        case nlohmann::json::value_t::null:
            return "null";
        case nlohmann::json::value_t::boolean:
            return value.get<bool>() ? "true" : "false";
        default:
            return number_text(document, pointer);
    }
}

std::string message_at(const Document& document, std::size_t byte, const std::string& pointer,
                       const std::string& text) {
    const Position position = position_of_byte(document.text, byte);
    return fmt::format("{}:{}:{}: {}: {}", document.file, position.line, position.column, shown_pointer(pointer), text);
}

// The place of a value: its pointer in the whole document, line and column in the file that wrote it.
static std::string message_in(const Document& document, const Issue& issue, const std::string& text) {
    const auto [source, there] = source_of(document, issue.pointer);
    return message_at(*source, locate(source->text, there, issue.target, issue.occurrence), issue.pointer, text);
}

std::string message(const Document& document, const Issue& issue) {
    std::string text = issue.sentence.empty() ? "expected " + issue.expected : issue.sentence;
    if (!issue.got.empty()) { text += ", got " + issue.got; }
    if (!issue.suggestion.empty()) { text += "; did you mean " + in_quotes(issue.suggestion) + "?"; }
    return message_in(document, issue, text);
}

void Diagnostics::mismatch(const std::string& pointer, const nlohmann::json& value, const std::string& expected,
                           const std::string& suggestion) {
    add({pointer, expected, shown(document_, value, pointer), suggestion});
}

void Diagnostics::raise() const {
    if (issues_.empty()) { return; }
    std::vector<std::pair<std::size_t, const Issue*>> places;
    for (const Issue& issue : issues_) {
        if (places.size() == most_places) { break; }
        places.emplace_back(locate(document_.text, issue.pointer, issue.target), &issue);
    }
    std::stable_sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::string text;
    for (std::size_t i = 0; i < std::min(places.size(), most_messages); ++i) {
        text += (i == 0 ? "" : "\n") + message(document_, *places[i].second);
    }
    if (issues_.size() > most_messages) {
        text += fmt::format("\n{}: {} more errors", document_.file, issues_.size() - most_messages);
    }
    throw Refusal(text, issues_);
}

}  // namespace kreisel
