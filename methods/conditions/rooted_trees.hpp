// SPDX-License-Identifier: BSD-3-Clause
//
// Rooted trees and the classical order conditions: sum_i b_i g_i(t) = 1/gamma(t) for every tree with up to p nodes,
//   g_i([t_1 ... t_m]) = prod_k sum_j a_ij g_j(t_k),   gamma([t_1 ... t_m]) = n gamma(t_1) ... gamma(t_m)
// [hairer1993, Sec. II.2]. A Munthe-Kaas method has the order of its tableau [munthekaas1999].
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "methods/conditions/numeric_tableau.hpp"

namespace kreisel::orders {

/// All rooted trees with up to `order` nodes, the smaller ones first: 1, 1, 2, 4, 9, 20, 48, 115, 286, 719 of them for
/// n = 1 to 10.
class RootedTrees {
  public:
    explicit RootedTrees(int order);
    std::size_t size() const { return nodes_.size(); }
    int nodes(std::size_t tree) const { return nodes_[tree]; }
    long density(std::size_t tree) const { return densities_[tree]; }  ///< gamma
    /// In ascending order, all of them before the tree.
    const std::vector<std::size_t>& branches(std::size_t tree) const { return branches_[tree]; }
    std::vector<std::size_t> of_order(int n) const;
    /// "t" for a node without branches, else its branches in brackets: "[t [t]]".
    std::string text(std::size_t tree) const;
    /// The elementary weight of a tree, to be summed over all indices: "b_i c_i a_ij c_j".
    std::string weight_text(std::size_t tree, const std::string& weights) const;

  private:
    /// What the node of `index` contributes, and the nodes above it, whose indices follow `last`.
    std::string factors(std::size_t tree, char index, char& last) const;
    /// Extends `branches` by trees not before `first` until they have `rest` nodes more.
    void extend(std::vector<std::size_t> branches, std::size_t first, int rest, int nodes);

    std::vector<std::vector<std::size_t>> branches_;
    std::vector<int> nodes_;
    std::vector<long> densities_;
};

/// The g(t) of the stages `a`, each computed once, when it is first needed; so is A g(t), for the trees that carry t.
template <class T>
class StageWeights {
  public:
    StageWeights(const RootedTrees& trees, const std::vector<std::vector<T>>& a)
        : trees_(trees), stages_(a.size()), g_(trees.size()), sums_(trees.size()) {
        for (const auto& row : a) {
            rows_.emplace_back();
            for (std::size_t j = 0; j < row.size(); ++j)
                if (row[j] != 0) rows_.back().push_back({j, row[j]});
        }
    }

    const RootedTrees& trees() const { return trees_; }

    /// sum_i w_i g_i(tree), the elementary weight.
    T weight(std::size_t tree, const std::vector<T>& w) {
        T sum = 0;
        const std::vector<T>& g = of(tree);
        for (std::size_t i = 0; i < w.size(); ++i)
            if (w[i] != 0) sum += w[i] * g[i];
        return sum;
    }

  private:
    const std::vector<T>& of(std::size_t tree) {
        if (!g_[tree].empty()) return g_[tree];
        std::vector<T> g(stages_, T(1));
        for (const std::size_t branch : trees_.branches(tree)) {
            const std::vector<T>& inner = sums(branch);
            for (std::size_t i = 0; i < stages_; ++i) g[i] *= inner[i];
        }
        return g_[tree] = std::move(g);
    }

    const std::vector<T>& sums(std::size_t tree) {
        if (!sums_[tree].empty()) return sums_[tree];
        const std::vector<T>& g = of(tree);
        std::vector<T> all;
        for (const auto& row : rows_) {
            all.push_back(T(0));
            for (const auto& [j, entry] : row) all.back() += entry * g[j];
        }
        return sums_[tree] = std::move(all);
    }

    const RootedTrees& trees_;
    std::size_t stages_;
    std::vector<std::vector<std::pair<std::size_t, T>>> rows_;  // without zeros
    std::vector<std::vector<T>> g_, sums_;
};

/// sum_i w_i g_i(t) - total/gamma(t) for the trees with exactly n nodes; total is 1 for the weights of a solution, 0
/// for the difference of two.
template <class T>
std::vector<T> butcher_conditions(StageWeights<T>& stages, const std::vector<T>& w, int n, int total = 1) {
    std::vector<T> residuals;
    for (const std::size_t tree : stages.trees().of_order(n))
        residuals.push_back(stages.weight(tree, w) - T(total) / T(stages.trees().density(tree)));
    return residuals;
}

/// By how much the weights miss the condition of a tree.
template <class T>
T missed_by(StageWeights<T>& stages, std::size_t tree, const std::vector<T>& w, int total = 1) {
    return stages.weight(tree, w) - T(total) / T(stages.trees().density(tree));
}

/// The first tree whose condition does not hold within `slack`; the number of trees if all hold.
template <class T>
std::size_t first_missed(StageWeights<T>& stages, const std::vector<T>& w, const T& slack, int total = 1) {
    std::size_t tree = 0;
    while (tree < stages.trees().size() && !(abs(missed_by(stages, tree, w, total)) > slack)) ++tree;
    return tree;
}

/// The largest p up to that of `trees` such that all conditions with up to p nodes hold within `slack`.
template <class T>
int butcher_order(StageWeights<T>& stages, const std::vector<T>& w, const T& slack, int total = 1) {
    const RootedTrees& trees = stages.trees();
    const std::size_t missed = first_missed(stages, w, slack, total);
    return missed < trees.size() ? trees.nodes(missed) - 1 : trees.nodes(trees.size() - 1);
}

}  // namespace kreisel::orders
