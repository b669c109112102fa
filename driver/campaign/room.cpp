// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/room.hpp"

#include <fmt/format.h>

#include "driver/campaign/workers/limits.hpp"
#include "driver/plan/estimate/amounts.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace fs = std::filesystem;

namespace {

constexpr double surely = 5;  // times what is free

// Of the disk that a folder is on, or will be.
double free_bytes(fs::path folder) {
    std::error_code error;
    folder = fs::absolute(folder, error);
    while (!fs::exists(folder, error) && folder.has_relative_path()) { folder = folder.parent_path(); }
    return static_cast<double>(fs::space(folder, error).available);
}

}  // namespace

std::string check_room(const Estimate& estimate, const fs::path& folder, const RunSettings& settings) {
    const double free = free_bytes(folder);
    const std::string disk = fmt::format("{}: results take about {} (an estimate), and {} are free", folder.string(),
                                         size_text(estimate.disk), size_text(free));
    if (estimate.disk > surely * free) { throw FileError(disk); }
    if (estimate.disk > free) { return disk; }
    const auto memory = static_cast<double>(settings.max_memory > 0 ? settings.max_memory : allowed_memory());
    if (estimate.memory <= memory) { return ""; }
    return fmt::format("{}: the run takes about {} of memory (an estimate), and may have {}; --shard makes it smaller",
                       folder.string(), size_text(estimate.memory), size_text(memory));
}

}  // namespace kreisel
