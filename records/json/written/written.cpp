// SPDX-License-Identifier: BSD-3-Clause
#include "records/json/written/written.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "records/json/exact.hpp"

namespace kreisel {

namespace {

constexpr std::size_t usual_parts = 4;

/// Most characters of values are digits and letters.
constexpr bool is_inside_word(char c) { return (c > ',' && c < '[') || (c >= 'a' && c <= 'z'); }

class Taker {
  public:
    explicit Taker(std::string_view text) : text_(text) {}

    template <class TakePart>
    void take_all(char begin, char end, const TakePart& take_part) {
        expect(begin);
        if (peek() != end) {
            take_part();
            while (peek() == ',') {
                ++at_;
                take_part();
            }
        }
        expect(end);
        if (at_ != text_.size()) { fail("nothing more"); }
    }

    /// A name without its quotes.
    std::string_view name() {
        const std::size_t start = at_ + 1;
        if (peek() != '"') { fail("a name"); }
        skip_string();
        const std::string_view name = text_.substr(start, at_ - start);
        ++at_;
        expect(':');
        return name;
    }

    /// All up to the comma or bracket behind a value.
    std::string_view value() {
        const std::size_t start = at_;
        for (int depth = 0;; ++at_) {
            const char c = peek();
            if (is_inside_word(c)) { continue; }
            const bool opens = c == '{' || c == '[', closes = c == '}' || c == ']';
            if (depth == 0 && (closes || c == ',')) { break; }
            depth += opens ? 1 : closes ? -1 : 0;
            if (c == '"') { skip_string(); }
        }
        if (at_ == start) { fail("a value"); }
        return text_.substr(start, at_ - start);
    }

  private:
    /// Moves from the first quote of a string to its last.
    void skip_string() {
        for (++at_; peek() != '"'; ++at_) { at_ += peek() == '\\' ? 1U : 0U; }
    }

    void expect(char c) {
        if (peek() != c) { fail(fmt::format("'{}'", c)); }
        ++at_;
    }

    char peek() const {
        if (at_ >= text_.size()) { fail("more"); }
        return text_[at_];
    }

    [[noreturn]] void fail(const std::string& expected) const {
        throw std::invalid_argument(fmt::format("byte {}: expected {}", at_ + 1, expected));
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

}  // namespace

std::vector<WrittenMember> members_of(std::string_view object) {
    std::vector<WrittenMember> members;
    members.reserve(usual_parts);
    Taker taker(object);
    taker.take_all('{', '}', [&] {
        const std::string_view name = taker.name();
        members.push_back({name, taker.value()});
    });
    return members;
}

std::vector<std::string_view> elements_of(std::string_view list) {
    std::vector<std::string_view> elements;
    elements.reserve(usual_parts);
    Taker taker(list);
    taker.take_all('[', ']', [&] { elements.push_back(taker.value()); });
    return elements;
}

std::string_view value_of(const std::vector<WrittenMember>& members, std::string_view name) {
    const auto found =
        std::find_if(members.begin(), members.end(), [&](const WrittenMember& member) { return member.name == name; });
    return found == members.end() ? std::string_view() : found->json;
}

std::string text_of(std::string_view json) {
    const bool plain = json.find('\\') == std::string_view::npos;
    if (!plain || json == "null") { return parse_exactly(json).text; }
    return std::string(json.starts_with('"') ? json.substr(1, json.size() - 2) : json);
}

}  // namespace kreisel
