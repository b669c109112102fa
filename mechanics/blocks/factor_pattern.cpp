// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/blocks/factor_pattern.hpp"

#include <map>
#include <utility>

#include "mechanics/blocks/elimination.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

using BlockAt = std::map<std::pair<std::size_t, std::size_t>, std::size_t>;

Elimination elimination(const BlockMatrix& pattern) {
    std::vector<std::set<int>> adjacent(pattern.rows.size());
    for (const auto& [row, col] : pattern.entries) adjacent[at(row)].insert(col), adjacent[at(col)].insert(row);
    return eliminate(std::move(adjacent));
}

/// Numbers the blocks of the factor, the diagonal first.
BlockAt number_blocks(const Elimination& order, std::vector<std::vector<FactorPattern::Below>>& columns) {
    const std::size_t joints = order.order.size();
    columns.resize(joints);
    BlockAt block;
    for (std::size_t k = 0; k < joints; ++k) block[{k, k}] = k;
    for (std::size_t k = 0; k < joints; ++k)
        for (const int row : order.neighbours[k]) {
            const std::size_t next = block.size();
            block[{at(row), k}] = next;
            columns[k].push_back({at(row), next});
        }
    return block;
}

/// Of each pair of blocks in a column.
std::vector<FactorPattern::Update> updates_of(const std::vector<FactorPattern::Below>& column, const BlockAt& block) {
    std::vector<FactorPattern::Update> updates;
    for (const auto& right : column)
        for (const auto& left : column)
            if (left.row >= right.row)
                updates.push_back({block.at({left.row, right.row}), left.block, right.block, left.row, right.row});
    return updates;
}

}  // namespace

FactorPattern::FactorPattern(const BlockMatrix& pattern) {
    const Elimination order = elimination(pattern);
    for (const int joint : order.order) {
        joint_at.push_back(at(joint));
        rows.push_back(pattern.rows[at(joint)]), offset.push_back(pattern.offset[at(joint)]);
    }
    const BlockAt block = number_blocks(order, columns);
    blocks = block.size();
    for (const auto& column : columns) updates.push_back(updates_of(column, block));
    for (std::size_t e = 0; e < pattern.entries.size(); ++e) {
        const std::size_t row = at(order.position[at(pattern.entries[e].row)]);
        const std::size_t col = at(order.position[at(pattern.entries[e].col)]);
        sources.push_back({e, block.at({max(row, col), min(row, col)}), row < col});
    }
}

std::size_t fill_in(const BlockMatrix& pattern) {
    std::size_t factor_blocks = 0;
    for (const auto& below : elimination(pattern).neighbours) factor_blocks += below.size();
    return factor_blocks - pattern.entries.size();
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
