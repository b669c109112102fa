// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/dispatch/job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace kreisel {

namespace {

constexpr std::string_view letters = "mosf";  // of CellEnd
constexpr char remarkable = '!', unremarkable = '.';
constexpr std::size_t marks = 2;  // before the line

}  // namespace

std::string Job::text() const {
    std::string written(1, static_cast<char>(kind));
    if (kind == Kind::reference) { return written + reference; }
    for (const std::size_t cell : cells) { written += fmt::format(" {}", cell); }
    return written;
}

Job Job::read(const std::string& text) {
    Job job{static_cast<Kind>(text.at(0)), {}, {}};
    if (job.kind == Kind::reference) {
        job.reference = text.substr(1);
    } else {
        std::istringstream numbers(text.substr(1));
        for (std::size_t cell = 0; numbers >> cell;) { job.cells.push_back(cell); }
    }
    return job;
}

std::string record_text(const CellEnding& ending, std::string_view line) {
    std::string text(1, letters[static_cast<std::size_t>(ending.end)]);
    text += ending.remarkable ? remarkable : unremarkable;
    return text += line;
}

CellEnding ending_in(std::string_view text) {
    const auto letter = letters.find(text.substr(0, 1));
    if (text.size() < marks || letter == std::string_view::npos) { return {}; }
    return {static_cast<CellEnd>(letter), text[1] == remarkable};
}

std::string_view line_in(std::string_view text) { return text.substr(std::min(marks, text.size())); }

std::string answer_text(Answered kind, std::string_view text) {
    return std::string(1, static_cast<char>(kind)) + std::string(text);
}

}  // namespace kreisel
