// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/shards.hpp"

#include <fmt/format.h>

#include "driver/plan/deal.hpp"
#include "support/hash.hpp"

namespace kreisel {

std::vector<std::size_t> cells_of_shard(const Plan& plan, std::size_t shard, std::size_t shards) {
    const std::vector<std::size_t> parts = deal(plan, shards);
    std::vector<std::size_t> cells;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i] == shard) { cells.push_back(i); }
    }
    return cells;
}

std::string plan_digest(const Plan& plan, std::size_t shards) {
    const std::vector<std::size_t> parts = deal(plan, shards);
    std::uint64_t hash = hash64(fmt::format("{}\n", shards));
    for (std::size_t i = 0; i < parts.size(); ++i) {
        hash = hash64(fmt::format("{} {}\n", plan.cells[i].hash(), parts[i]), hash);
    }
    return hash_text(hash);
}

}  // namespace kreisel
