// SPDX-License-Identifier: BSD-3-Clause
#include "records/json/locator.hpp"

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

namespace kreisel {

namespace {

// Walks over JSON text without recursion; at the end of the text no step moves.
class Scanner {
  public:
    explicit Scanner(std::string_view text) : text_(text) {}

    std::size_t at() const { return at_; }
    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
    bool ended() const { return at_ >= text_.size(); }
    void advance() {
        if (!ended()) ++at_;
    }

    void skip_space() {
        while (!ended() && std::string_view(" \t\r\n").find(peek()) != std::string_view::npos) { advance(); }
    }

    std::string_view skip_string() {
        const std::size_t start = at_;
        for (advance(); !ended() && peek() != '"'; advance()) {
            if (peek() == '\\') { advance(); }
        }
        advance();
        return text_.substr(start, at_ - start);
    }

    void skip_value() {
        int depth = 0;
        do {
            skip_space();
            const char c = peek();
            if (c == '"') {
                skip_string();
                continue;
            }
            depth += c == '{' || c == '[' ? 1 : 0;
            depth -= c == '}' || c == ']' ? 1 : 0;
            if (depth == 0 && c != '}' && c != ']') {
                skip_scalar();
                return;
            }
            advance();
        } while (depth > 0 && !ended());
    }

  private:
    void skip_scalar() {
        while (!ended() && std::string_view(",]} \t\r\n").find(peek()) == std::string_view::npos) { advance(); }
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

std::string decoded(std::string_view quoted) {
    const auto value = nlohmann::json::parse(quoted, nullptr, false);
    return value.is_string() ? value.get<std::string>() : std::string();
}

bool is_text(std::string_view quoted, const std::string& text) {
    if (quoted.find('\\') != std::string_view::npos) { return decoded(quoted) == text; }
    return quoted.size() == text.size() + 2 && quoted.substr(1, text.size()) == text;
}

// Moves to the value of `key`; returns where the key stands, or nothing if the object has none.
std::optional<std::size_t> enter_member(Scanner& scan, const std::string& key, int occurrence) {
    for (scan.advance(), scan.skip_space(); scan.peek() == '"'; scan.skip_space()) {
        const std::size_t key_at = scan.at();
        const bool same = is_text(scan.skip_string(), key);
        scan.skip_space();
        scan.advance();  // the colon
        scan.skip_space();
        if (same && --occurrence == 0) { return key_at; }
        scan.skip_value();
        scan.skip_space();
        if (scan.peek() == ',') { scan.advance(); }
    }
    return std::nullopt;
}

std::optional<std::size_t> enter_element(Scanner& scan, const std::string& token) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), index);
    if (error != std::errc() || end != token.data() + token.size()) { return std::nullopt; }
    for (scan.advance(), scan.skip_space(); !scan.ended() && scan.peek() != ']'; scan.skip_space()) {
        if (index-- == 0) { return scan.at(); }
        scan.skip_value();
        scan.skip_space();
        if (scan.peek() == ',') { scan.advance(); }
    }
    return std::nullopt;
}

std::vector<std::string> reference_tokens(const std::string& pointer) {
    std::vector<std::string> tokens;
    for (std::size_t i = 0; i < pointer.size(); ++i) {
        if (pointer[i] == '/') {
            tokens.emplace_back();
        } else if (tokens.empty()) {
            break;
        } else if (pointer[i] == '~' && i + 1 < pointer.size()) {
            tokens.back() += pointer[++i] == '0' ? '~' : '/';
        } else {
            tokens.back() += pointer[i];
        }
    }
    return tokens;
}

}  // namespace

Position position_of_byte(std::string_view text, std::size_t byte) {
    Position position;
    for (std::size_t i = 0; i < std::min(byte, text.size()); ++i) {
        const bool continuation = (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;
        position.column += continuation ? 0 : 1;
        if (text[i] == '\n') {
            position.line += 1;
            position.column = 1;
        }
    }
    return position;
}

std::size_t locate(std::string_view text, const std::string& pointer, Target target, int occurrence) {
    Scanner scan(text);
    scan.skip_space();
    std::size_t found = scan.at();
    const auto tokens = reference_tokens(pointer);
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const bool last = i + 1 == tokens.size();
        std::optional<std::size_t> entered;
        if (scan.peek() == '{') {
            entered = enter_member(scan, tokens[i], last ? occurrence : 1);
        } else if (scan.peek() == '[') {
            entered = enter_element(scan, tokens[i]);
        }
        if (!entered) { return found; }
        found = last && target == Target::key ? *entered : scan.at();
    }
    return found;
}

std::string pointer_below(const std::string& pointer, std::string_view token) {
    std::string result = pointer + "/";
    for (const char c : token) {
        if (c == '~') {
            result += "~0";
        } else if (c == '/') {
            result += "~1";
        } else {
            result += c;
        }
    }
    return result;
}

}  // namespace kreisel
