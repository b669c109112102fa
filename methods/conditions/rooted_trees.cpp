// SPDX-License-Identifier: BSD-3-Clause
#include "methods/conditions/rooted_trees.hpp"

#include <algorithm>

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

std::string RootedTrees::text(std::size_t tree) const {
    std::string inner;
    for (const std::size_t branch : branches_[tree]) inner += (inner.empty() ? "" : " ") + text(branch);
    return inner.empty() ? "t" : "[" + inner + "]";
}

std::string RootedTrees::weight_text(std::size_t tree, const std::string& weights) const {
    char last = 'i';
    return weights + "_i" + factors(tree, 'i', last);
}

std::string RootedTrees::factors(std::size_t tree, char index, char& last) const {
    const auto& branches = branches_[tree];
    const auto first = std::find_if(branches.begin(), branches.end(), [](std::size_t branch) { return branch > 0; });
    std::string product;
    if (const auto leaves = first - branches.begin(); leaves > 0)
        product += std::string(" c_") + index + (leaves > 1 ? "^" + std::to_string(leaves) : "");
    for (auto branch = first; branch != branches.end(); ++branch) {
        const char next = ++last;
        product += std::string(" a_") + index + next + factors(*branch, next, last);
    }
    return product;
}

std::vector<std::size_t> RootedTrees::of_order(int n) const {
    std::vector<std::size_t> trees;
    for (std::size_t tree = 0; tree < nodes_.size(); ++tree)
        if (nodes_[tree] == n) trees.push_back(tree);
    return trees;
}

}  // namespace kreisel::orders
