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

std::vector<Rational> RootedTrees::stage_weights(std::size_t tree, const NumericTableau<Rational>& tableau) const {
    std::vector<Rational> g(tableau.b.size(), Rational(1));
    for (const std::size_t branch : branches_[tree]) {
        const auto inner = stage_weights(branch, tableau);
        for (std::size_t i = 0; i < g.size(); ++i) {
            Rational sum = 0;
            for (std::size_t j = 0; j < tableau.a[i].size(); ++j) sum += tableau.a[i][j] * inner[j];
            g[i] *= sum;
        }
    }
    return g;
}

Rational RootedTrees::weight(std::size_t tree, const NumericTableau<Rational>& tableau) const {
    const auto g = stage_weights(tree, tableau);
    Rational sum = 0;
    for (std::size_t i = 0; i < g.size(); ++i) sum += tableau.b[i] * g[i];
    return sum;
}

std::vector<Rational> butcher_conditions(const NumericTableau<Rational>& tableau, int order) {
    const RootedTrees trees(order);
    std::vector<Rational> residuals;
    for (const std::size_t tree : trees.of_order(order))
        residuals.push_back(trees.weight(tree, tableau) - Rational(1, trees.density(tree)));
    return residuals;
}

}  // namespace kreisel::orders
