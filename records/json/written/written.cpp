// SPDX-License-Identifier: BSD-3-Clause
#include "records/json/written/written.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "records/json/exact.hpp"

namespace kreisel {

namespace {

constexpr std::size_t usual_scalars = 9;                   // of a matrix
constexpr std::size_t usual_parts = 4, usual_member = 32;  // characters of a member in a large object

/// What values are taken apart at: most of their characters are others.
constexpr auto is_mark = [] {
    std::array<bool, 256> marks{};
    for (const char c : std::string_view("\"{}[],")) { marks[static_cast<unsigned char>(c)] = true; }
    return marks;
}();

class Taker {
  public:
    explicit Taker(std::string_view text) : text_(text) {}

    template <class TakePart>
    void take_all(char begin, char end, const TakePart& take_part) {
        take_list(begin, end, take_part);
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
            at_ = next_mark(at_);
            const char c = peek();
            const bool opens = c == '{' || c == '[', closes = c == '}' || c == ']';
            if (depth == 0 && (closes || c == ',')) { break; }
            depth += opens ? 1 : closes ? -1 : 0;
            if (c == '"') { skip_string(); }
        }
        if (at_ == start) { fail("a value"); }
        return text_.substr(start, at_ - start);
    }

    /// A value that is no list, or the elements of one.
    void take_scalars(std::vector<std::string_view>& scalars) {
        if (peek() != '[') { return scalars.push_back(value()); }
        take_list('[', ']', [&] { scalars.push_back(value()); });
    }

  private:
    template <class TakePart>
    void take_list(char begin, char end, const TakePart& take_part) {
        expect(begin);
        if (peek() != end) {
            take_part();
            while (peek() == ',') {
                ++at_;
                take_part();
            }
        }
        expect(end);
    }

    std::size_t next_mark(std::size_t at) const {
        while (at < text_.size() && !is_mark[static_cast<unsigned char>(text_[at])]) { ++at; }
        return at;
    }

    /// Moves from the first quote of a string to its last.
    void skip_string() {
        std::size_t at = at_ + 1;
        while (at < text_.size() && text_[at] != '"') { at += text_[at] == '\\' ? 2U : 1U; }
        at_ = at;
        peek();
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
    members.reserve(usual_parts + object.size() / usual_member);
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

std::vector<std::string_view> scalars_of(std::string_view list) {
    std::vector<std::string_view> scalars;
    scalars.reserve(usual_scalars);
    Taker taker(list);
    taker.take_all('[', ']', [&] { taker.take_scalars(scalars); });
    return scalars;
}

std::string_view WrittenObject::value_of(std::string_view name) {
    const auto fits = [&](const WrittenMember& member) { return member.name == name; };
    const auto next = members_.begin() + static_cast<std::ptrdiff_t>(next_);
    const auto found =
        next != members_.end() && fits(*next) ? next : std::find_if(members_.begin(), members_.end(), fits);
    if (found == members_.end()) { return {}; }
    next_ = static_cast<std::size_t>(found - members_.begin()) + 1;
    return found->json;
}

std::string text_of(std::string_view json) {
    std::string unescaped;
    return std::string(text_of(json, unescaped));
}

std::string_view text_of(std::string_view json, std::string& unescaped) {
    const bool plain = json.find('\\') == std::string_view::npos;
    if (!plain || json == "null") { return unescaped = parse_exactly(json).text; }
    return json.starts_with('"') ? json.substr(1, json.size() - 2) : json;
}

}  // namespace kreisel
