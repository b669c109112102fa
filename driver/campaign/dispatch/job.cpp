// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/dispatch/job.hpp"

#include <fmt/format.h>

#include <sstream>

namespace kreisel {

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

std::string answer_text(Answered kind, std::string_view text) {
    return std::string(1, static_cast<char>(kind)) + std::string(text);
}

}  // namespace kreisel
