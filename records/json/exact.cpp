// SPDX-License-Identifier: BSD-3-Clause
#include "records/json/exact.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "records/json/lists.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

/// Deeper nesting is damage, and would exhaust the stack.
constexpr int deepest = 100;

constexpr std::size_t usual_members = 8, usual_elements = 3;  // of an object, a list

constexpr std::size_t skip_digits(std::string_view word, std::size_t at) {
    while (at < word.size() && word[at] >= '0' && word[at] <= '9') { ++at; }
    return at;
}

/// -0.5e-10: JSON has no other numbers than this shape.
bool is_json_number(std::string_view word) {
    const auto begins = [&](std::size_t at, std::string_view any) {
        return at < word.size() && any.find(word[at]) != std::string_view::npos;
    };
    const std::size_t first = begins(0, "-") ? 1 : 0;
    std::size_t at = skip_digits(word, first), digits = at - first;
    if (digits == 0 || (digits > 1 && word[first] == '0')) { return false; }
    if (begins(at, ".")) {
        digits = skip_digits(word, at + 1) - (at + 1);
        if (digits == 0) { return false; }
        at += 1 + digits;
    }
    if (begins(at, "eE")) {
        at += begins(at + 1, "+-") ? 2U : 1U;
        digits = skip_digits(word, at) - at;
        at += digits;
    }
    return digits > 0 && at == word.size();
}

constexpr bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

constexpr bool ends_word(char c) { return c == ',' || c == ']' || c == '}' || is_space(c); }

class ExactReader {
  public:
    explicit ExactReader(std::string_view text) : text_(text) {}

    JsonValue read_all() {
        JsonValue value = read();
        skip_space();
        if (at_ != text_.size()) { fail("nothing more"); }
        return value;
    }

  private:
    JsonValue read() {
        skip_space();
        switch (peek()) {
            case '{':
                return read_object();
            case '[':
                return read_list();
            case '"':
                return {JsonValue::Kind::text, read_string(), {}, {}};
            default:
                return read_word();
        }
    }

    JsonValue read_object() {
        JsonValue object{JsonValue::Kind::object, "", {}, {}};
        object.members.reserve(usual_members);
        read_entries('}', [&] {
            std::string name = read_string();
            expect(':');
            if (object.find(name) != nullptr) { fail(fmt::format("each name once, not a second \"{}\"", name)); }
            object.members.push_back({std::move(name), read()});
        });
        return object;
    }

    JsonValue read_list() {
        JsonValue list{JsonValue::Kind::list, "", {}, {}};
        list.elements.reserve(usual_elements);
        read_entries(']', [&] { list.elements.push_back(read()); });
        return list;
    }

    template <class ReadEntry>
    void read_entries(char end, const ReadEntry& read_entry) {
        if (++depth_ > deepest) { fail("no deeper nesting"); }
        ++at_;
        skip_space();
        for (bool first = true; peek() != end; first = false) {
            if (!first) { expect(','); }
            skip_space();
            read_entry();
            skip_space();
        }
        ++at_;
        --depth_;
    }

    std::string read_string() {
        const std::size_t start = at_;
        expect('"');
        bool plain = true;
        for (; peek() != '"'; ++at_) {
            const bool escape = peek() == '\\';
            plain = plain && !escape && static_cast<unsigned char>(peek()) >= 0x20;
            at_ += escape ? 1U : 0U;
        }
        const std::string_view quoted = text_.substr(start, ++at_ - start);
        if (plain) { return std::string(quoted.substr(1, quoted.size() - 2)); }
        const auto value = nlohmann::json::parse(quoted, nullptr, false);
        if (!value.is_string()) { fail("a string"); }
        return value.get<std::string>();
    }

    /// A number, true, false or null.
    JsonValue read_word() {
        const std::size_t start = at_;
        while (at_ < text_.size() && !ends_word(text_[at_])) { ++at_; }
        const std::string_view word = text_.substr(start, at_ - start);
        if (word == "null") { return {}; }
        const bool flag = word == "true" || word == "false";
        if (!flag && !is_json_number(word)) { fail("a value"); }
        return {flag ? JsonValue::Kind::flag : JsonValue::Kind::number, std::string(word), {}, {}};
    }

    void expect(char c) {
        skip_space();
        if (peek() != c) { fail(fmt::format("'{}'", c)); }
        ++at_;
        skip_space();
    }

    char peek() const {
        if (at_ >= text_.size()) { fail("more"); }
        return text_[at_];
    }

    void skip_space() {
        while (at_ < text_.size() && is_space(text_[at_])) { ++at_; }
    }

    [[noreturn]] void fail(const std::string& expected) const {
        throw std::invalid_argument(fmt::format("byte {}: expected {}", at_ + 1, expected));
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

template <class WriteNumber>
std::string json_of(const JsonValue& value, const WriteNumber& number) {
    const auto write = [&](const JsonValue& entry) { return json_of(entry, number); };
    switch (value.kind) {
        case JsonValue::Kind::null:
            return "null";
        case JsonValue::Kind::flag:
            return value.text;
        case JsonValue::Kind::number:
            return number(value);
        case JsonValue::Kind::text:
            return json_text(value.text);
        case JsonValue::Kind::list:
            return json_list(value.elements, write);
        case JsonValue::Kind::object:
            break;
    }
    ObjectWriter object;
    for (const JsonMember& member : value.members) { object.member(member.name, write(member.value)); }
    return object.text();
}

[[noreturn]] void refuse(const char* expected, const JsonValue& value) {
    throw std::invalid_argument(fmt::format("expected {}, got {}", expected, json_value(value)));
}

}  // namespace

// Written out: clang 14 crashes on a default for a class that holds others of its kind.
bool JsonValue::operator==(const JsonValue& other) const {
    return kind == other.kind && text == other.text && elements == other.elements && members == other.members;
}

const JsonValue* JsonValue::find(std::string_view name) const {
    for (const JsonMember& member : members) {
        if (member.name == name) { return member.value.is_null() ? nullptr : &member.value; }
    }
    return nullptr;
}

const JsonValue& JsonValue::at(std::string_view name) const {
    const JsonValue* found = find(name);
    if (found == nullptr) { throw std::invalid_argument(fmt::format("\"{}\" is missing", name)); }
    return *found;
}

// Decimals out of the range of doubles are 0 or infinite to strtod, which takes several times as long.
double JsonValue::number() const {
    double result = 0;
    const char* const behind = text.data() + text.size();
    auto [end, error] = std::from_chars(text.data(), behind, result);
    if (error == std::errc::result_out_of_range) { result = std::strtod(text.c_str(), nullptr); }
    const bool whole = (kind == Kind::number || kind == Kind::text) && !text.empty() && end == behind;
    if (!whole || !std::isfinite(result)) { refuse("a number", *this); }
    return result;
}

long JsonValue::count() const {
    const double value = kind == Kind::number ? number() : 0.5;
    if (value != std::floor(value) || std::fabs(value) > largest_exact_whole) { refuse("a whole number", *this); }
    return static_cast<long>(value);
}

bool JsonValue::flag() const {
    if (kind != Kind::flag) { refuse("true or false", *this); }
    return text == "true";
}

const std::string& JsonValue::string() const {
    if (kind != Kind::text) { refuse("a string", *this); }
    return text;
}

JsonValue parse_exactly(std::string_view text) { return ExactReader(text).read_all(); }

std::string json_value(const JsonValue& value) {
    return json_of(value, [](const JsonValue& number) { return number.text; });
}

std::string canonical_json(const JsonValue& value) {
    return json_of(value, [](const JsonValue& number) { return json_number(number.number()); });
}

}  // namespace kreisel
