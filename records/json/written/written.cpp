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

/// What values are taken apart at: most of their characters are none of these.
enum class Mark : unsigned char { none, comma, quote, opens, closes };

constexpr auto marks = [] {
    std::array<Mark, 256> marks{};
    marks[','] = Mark::comma;
    marks['"'] = Mark::quote;
    marks['{'] = marks['['] = Mark::opens;
    marks['}'] = marks[']'] = Mark::closes;
    return marks;
}();

class Taker {
  public:
    explicit Taker(std::string_view text) : text_(text) {}

    template <class TakePart>
    void take_all(char begin, char end, const TakePart& take_part) {
        take_list(begin, end, take_part);
        expect_end();
    }

    /// The members of an object behind those that are known.
    template <class TakePart>
    void take_behind(std::size_t known, const TakePart& take_part) {
        at_ = known;
        take_more('}', take_part);
        expect_end();
    }

    WrittenMember member() {
        const std::string_view key = name();
        return {key, value()};
    }

    /// All up to the comma or bracket behind a value.
    std::string_view value() {
        const std::size_t start = at_;
        std::size_t at = at_;
        for (int depth = 0; at < text_.size(); ++at) {
            const Mark mark = marks[static_cast<unsigned char>(text_[at])];
            if (mark == Mark::none || (mark == Mark::comma && depth > 0)) { continue; }
            if (mark == Mark::quote) {
                at = end_of_string(at);
            } else if (mark == Mark::opens) {
                ++depth;
            } else if (depth-- == 0) {
                break;
            }
        }
        at_ = at;
        peek();
        if (at_ == start) { fail("a value"); }
        return text_.substr(start, at_ - start);
    }

    /// A value that is no list, or the elements of one.
    void take_scalars(std::vector<std::string_view>& scalars) {
        if (peek() != '[') { return scalars.push_back(value()); }
        take_list('[', ']', [&] { scalars.push_back(value()); });
    }

    /// What stands in a list, with its place behind the path.
    void take_scalars(std::string& path, const std::function<void(std::string_view)>& visit) {
        const std::size_t size = path.size();
        std::size_t index = 0;
        take_list('[', ']', [&] {
            path.append(".").append(std::to_string(++index));
            peek() == '[' ? take_scalars(path, visit) : visit(value());
            path.resize(size);
        });
    }

    void expect_end() const {
        if (at_ != text_.size()) { fail("nothing more"); }
    }

  private:
    /// Without its quotes.
    std::string_view name() {
        const std::size_t start = at_ + 1;
        if (peek() != '"') { fail("a name"); }
        at_ = end_of_string(at_);
        const std::string_view name = text_.substr(start, at_ - start);
        ++at_;
        expect(':');
        return name;
    }

    template <class TakePart>
    void take_list(char begin, char end, const TakePart& take_part) {
        expect(begin);
        if (peek() != end) { take_part(); }
        take_more(end, take_part);
    }

    template <class TakePart>
    void take_more(char end, const TakePart& take_part) {
        while (peek() == ',') {
            ++at_;
            take_part();
        }
        expect(end);
    }

    /// From the first quote of a string to its last, or the end of all.
    std::size_t end_of_string(std::size_t at) const {
        for (++at; at < text_.size() && text_[at] != '"'; ++at) { at += text_[at] == '\\' ? 1U : 0U; }
        return at;
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
    taker.take_all('{', '}', [&] { members.push_back(taker.member()); });
    return members;
}

std::vector<WrittenMember> members_behind(std::string_view begin, std::string_view object) {
    const std::size_t size = begin.size();  // behind which a number might go on
    const bool begins =
        object.starts_with(begin) && object.size() > size && (object[size] == ',' || object[size] == '}');
    if (!begins) { return members_of(object); }
    std::vector<WrittenMember> members;
    members.reserve(usual_parts + (object.size() - size) / usual_member);
    Taker taker(object);
    taker.take_behind(size, [&] { members.push_back(taker.member()); });
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

void for_each_scalar(std::string_view json, std::string& path, const std::function<void(std::string_view)>& visit) {
    if (!json.starts_with('[')) { return visit(json); }
    Taker taker(json);
    taker.take_scalars(path, visit);
    taker.expect_end();
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
