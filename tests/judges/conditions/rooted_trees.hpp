// SPDX-License-Identifier: BSD-3-Clause
//
// Rooted trees and the classical order conditions: sum_i b_i g_i(t) = 1/gamma(t) for every tree with up to p nodes,
//   g_i([t_1 ... t_m]) = prod_k sum_j a_ij g_j(t_k),   gamma([t_1 ... t_m]) = n gamma(t_1) ... gamma(t_m)
// [hairer1993, Sec. II.2]. A Munthe-Kaas method has the order of its tableau [munthekaas1999].
#pragma once

#include <cstddef>
#include <vector>

#include "tests/judges/conditions/numeric_tableau.hpp"

namespace kreisel::orders {

/// All rooted trees with up to `order` nodes: 1, 1, 2, 4, 9, 20 of them for n = 1 to 6.
class RootedTrees {
  public:
    explicit RootedTrees(int order);
    std::vector<std::size_t> of_order(int n) const;
    long density(std::size_t tree) const { return densities_[tree]; }  ///< gamma
    /// sum_i b_i g_i(tree), the elementary weight.
    Rational weight(std::size_t tree, const NumericTableau<Rational>& tableau) const;

  private:
    /// Extends `branches` by trees not before `first` until they have `rest` nodes more.
    void extend(std::vector<std::size_t> branches, std::size_t first, int rest, int nodes);
    std::vector<Rational> stage_weights(std::size_t tree, const NumericTableau<Rational>& tableau) const;

    std::vector<std::vector<std::size_t>> branches_;  ///< of each tree, in ascending order
    std::vector<int> nodes_;
    std::vector<long> densities_;
};

/// Elementary weight minus 1/gamma for the trees with exactly `order` nodes.
std::vector<Rational> butcher_conditions(const NumericTableau<Rational>& tableau, int order);

/// Largest p up to 6 such that the conditions of the orders 1 to p hold within `slack`.
inline int butcher_order(const NumericTableau<Rational>& tableau, const Rational& slack) {
    int order = 0;
    while (order < 6 && all_within(butcher_conditions(tableau, order + 1), slack)) ++order;
    return order;
}

}  // namespace kreisel::orders
