// SPDX-License-Identifier: BSD-3-Clause
//
// Symbolic elimination of a sparse symmetric matrix: an order of low fill, and the pattern of the factor.
#pragma once

#include <set>
#include <utility>
#include <vector>

namespace kreisel {

/// Vertices that share an edge have an off-diagonal block. Eliminating a vertex joins its remaining neighbours.
struct Elimination {
    std::vector<int> order;     ///< position -> vertex
    std::vector<int> position;  ///< vertex -> position
    std::vector<std::vector<int>>
        neighbours;  ///< of the vertex at a position when eliminated, as positions, increasing
};

/// Minimum degree, ties by index: leaves first, so a chain or a tree has no fill.
inline Elimination eliminate(std::vector<std::set<int>> adjacent) {
    const auto n = adjacent.size();
    Elimination e;
    e.position.assign(n, -1);
    std::set<std::pair<std::size_t, int>> queue;
    for (std::size_t i = 0; i < n; ++i) queue.insert({adjacent[i].size(), static_cast<int>(i)});
    const auto update = [&](int i, auto&& change) {
        auto& set = adjacent[static_cast<std::size_t>(i)];
        queue.erase({set.size(), i});
        change(set);
        queue.insert({set.size(), i});
    };
    while (!queue.empty()) {
        const int pivot = queue.begin()->second;
        queue.erase(queue.begin());
        const std::set<int> around = std::move(adjacent[static_cast<std::size_t>(pivot)]);
        e.position[static_cast<std::size_t>(pivot)] = static_cast<int>(e.order.size());
        e.order.push_back(pivot);
        e.neighbours.emplace_back(around.begin(), around.end());
        for (const int i : around)
            update(i, [&](std::set<int>& set) {
                set.erase(pivot);
                for (const int j : around)
                    if (j != i) set.insert(j);
            });
    }
    for (auto& row : e.neighbours) {
        for (int& vertex : row) vertex = e.position[static_cast<std::size_t>(vertex)];
        std::set<int> sorted(row.begin(), row.end());
        row.assign(sorted.begin(), sorted.end());
    }
    return e;
}

}  // namespace kreisel
