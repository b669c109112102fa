// SPDX-License-Identifier: BSD-3-Clause
#include "records/sums/summed_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "support/hash.hpp"

namespace kreisel {

std::string with_sum(std::string_view open, const SumStyle& style) {
    return fmt::format("{}{}{}{}", open, style.before, hash_text(open), style.after);
}

SumState sum_state(std::string_view object, const SumStyle& style) {
    // Unescaped quotes do not occur inside a JSON string, so this can only be a member.
    const auto at = object.rfind(style.before);
    if (at == std::string_view::npos) { return SumState::absent; }
    return with_sum(object.substr(0, at), style) == object ? SumState::holds : SumState::wrong;
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
