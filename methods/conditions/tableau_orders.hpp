// SPDX-License-Identifier: BSD-3-Clause
//
// What the classical order conditions say of an explicit tableau or an embedded pair, in rational arithmetic where all
// coefficients are rationals, else in 100 digits within 1e-40, the last digits written, times the size of the tableau.
#pragma once

#include <string>

#include "methods/conditions/rooted_trees.hpp"

namespace kreisel::orders {

/// Higher orders are not distinguished from this one.
inline constexpr int most_order = 10;

/// Of b, and of a pair, of b^ and of e = h sum_i (b_i - b^_i) k_i = O(h^difference).
struct TableauOrders {
    int step = 0, embedded = 0, difference = 0;
    /// The first condition that b misses, and b^: "sum b_i c_i a_ij c_j = 1/8 (tree [t [t]]) is missed by 0.0417";
    /// empty if none up to most_order is.
    std::string missed = {}, missed_embedded = {};
};
TableauOrders tableau_orders(const NumericTableau<Rational>& tableau, const Rational& slack);
TableauOrders tableau_orders(const NumericTableau<Float100>& tableau, const Float100& slack);
TableauOrders tableau_orders(const Tableau& tableau);

/// The largest order up to which sum_i b_i(theta) g_i(t) = theta^n/gamma(t) holds for all theta, n the nodes of the
/// tree t: coefficient by coefficient. 0 where there is no dense output, or b(1) is not b.
int dense_order(const Tableau& tableau);

/// The order of b up to most_order; in 100 digits where `slack` is not zero.
int butcher_order(const NumericTableau<Rational>& tableau, const Rational& slack);

/// The objection to the declared order p and to r, the declared order of the estimate in h
/// (MethodDescription::estimate; 0: none). b has order p and no more; e has order r and no more, and estimates an
/// error: r <= p, or r = p + 1 and b^ has order p + 1.
std::string orders_objection(const TableauOrders& found, int p, int r);

/// The same for a tableau, whose rows must sum to the nodes given in `c`: a misprint is named by its row.
std::string tableau_objection(const Tableau& tableau, int p, int r);

}  // namespace kreisel::orders
