// SPDX-License-Identifier: BSD-3-Clause
#include "records/sums/summed_text.hpp"

#include <algorithm>
#include <stdexcept>

#include "support/hash.hpp"

namespace kreisel {

namespace {

constexpr std::size_t digits_of_sum = 16;

}  // namespace

std::string with_sum(std::string_view open, const SumStyle& style) {
    std::string text;
    text.reserve(open.size() + style.before.size() + digits_of_sum + style.after.size());
    text.append(open).append(style.before).append(hash_text(open)).append(style.after);
    return text;
}

SumState sum_state(std::string_view object, const SumStyle& style) {
    // Unescaped quotes do not occur inside a JSON string, so this can only be a member.
    const auto at = object.rfind(style.before);
    if (at == std::string_view::npos) { return SumState::absent; }
    const std::string_view rest = object.substr(at + style.before.size());
    const bool holds = rest.size() == digits_of_sum + style.after.size() && rest.ends_with(style.after) &&
                       rest.substr(0, digits_of_sum) == hash_text(object.substr(0, at));
    return holds ? SumState::holds : SumState::wrong;
}

std::string_view before_sum(std::string_view object, const SumStyle& style) {
    return object.substr(0, object.rfind(style.before));
}

bool lines_have_sums(const std::vector<std::string>& lines, bool known) {
    return known || std::any_of(lines.begin(), lines.end(),
                                [](const std::string& line) { return sum_state(line) == SumState::holds; });
}

void require_sum(const std::string& line, bool expected) {
    const SumState sum = sum_state(line);
    if (sum == SumState::wrong || (expected && sum == SumState::absent)) {
        throw std::invalid_argument("damaged: its sum does not hold");
    }
}

}  // namespace kreisel
