// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/conditions/rooted_trees.hpp"

namespace kreisel::orders {

RootedTrees::RootedTrees(int order) {
    for (int n = 1; n <= order; ++n) extend({}, 0, n - 1, n);
}

void RootedTrees::extend(std::vector<std::size_t> branches, std::size_t first, int rest, int nodes) {
    if (rest == 0) {
        long density = nodes;
        for (const std::size_t branch : branches) density *= densities_[branch];
        branches_.push_back(branches);
        nodes_.push_back(nodes);
        densities_.push_back(density);
        return;
    }
    branches.push_back(0);
    for (std::size_t branch = first; branch < nodes_.size() && nodes_[branch] <= rest; ++branch) {
        branches.back() = branch;
        extend(branches, branch, rest - nodes_[branch], nodes);
    }
}

std::vector<std::size_t> RootedTrees::of_order(int n) const {
    std::vector<std::size_t> trees;
    for (std::size_t tree = 0; tree < nodes_.size(); ++tree)
        if (nodes_[tree] == n) trees.push_back(tree);
    return trees;
}

}  // namespace kreisel::orders
