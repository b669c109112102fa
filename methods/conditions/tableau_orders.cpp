// SPDX-License-Identifier: BSD-3-Clause
#include "methods/conditions/tableau_orders.hpp"

#include <algorithm>

namespace kreisel::orders {

namespace {

const RootedTrees& all_trees() {
    static const RootedTrees trees(most_order);
    return trees;
}

/// By what the rounding of single coefficients can grow in a condition: the largest sum of a row, at least 1.
template <class T>
T size_of(const NumericTableau<T>& tableau) {
    T largest = 1;
    const auto see = [&](const std::vector<T>& row) {
        T sum = 0;
        for (const T& entry : row) sum += abs(entry);
        if (sum > largest) largest = sum;
    };
    for (const auto& row : tableau.a) see(row);
    see(tableau.b);
    see(tableau.b_hat);
    return largest;
}

template <class T>
std::string missed_text(StageWeights<T>& stages, const std::vector<T>& w, const std::string& name, std::size_t tree) {
    const RootedTrees& trees = stages.trees();
    if (tree == trees.size()) return "";
    const Float100 by(missed_by(stages, tree, w));
    return "sum " + trees.weight_text(tree, name) + " = 1" +
           (tree > 0 ? "/" + std::to_string(trees.density(tree)) : "") + " (tree " + trees.text(tree) +
           ") is missed by " + by.str(3);
}

template <class T>
TableauOrders orders_in(const NumericTableau<T>& tableau, const T& slack) {
    const T within = slack * size_of(tableau);
    StageWeights<T> stages(all_trees(), tableau.a);
    const auto order_of = [&](const std::vector<T>& w, const std::string& name, std::string& missed) {
        const std::size_t tree = first_missed(stages, w, within);
        missed = missed_text(stages, w, name, tree);
        return tree < all_trees().size() ? all_trees().nodes(tree) - 1 : most_order;
    };
    TableauOrders found;
    found.step = order_of(tableau.b, "b", found.missed);
    if (tableau.b_hat.empty()) return found;
    found.embedded = order_of(tableau.b_hat, "b_hat", found.missed_embedded);
    std::vector<T> e = tableau.b;
    for (std::size_t i = 0; i < e.size(); ++i) e[i] -= tableau.b_hat.at(i);
    found.difference = butcher_order(stages, e, within, 0) + 1;
    return found;
}

/// The weights of theta, theta^2, ...
std::vector<std::vector<Rational>> powers_of(const std::vector<std::vector<Coefficient>>& dense) {
    std::vector<std::vector<Rational>> powers;
    for (std::size_t i = 0; i < dense.size(); ++i)
        for (std::size_t k = 0; k < dense[i].size(); ++k) {
            if (k == powers.size()) powers.emplace_back(dense.size(), Rational(0));
            powers[k][i] = exact(dense[i][k]);
        }
    return powers;
}

bool ends_at(const std::vector<Rational>& b, const std::vector<std::vector<Rational>>& powers, const Rational& slack) {
    std::vector<Rational> rest = b;
    for (const auto& weights : powers)
        for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= weights.at(i);
    return all_within(rest, slack);
}

/// The order up to which the weights of theta^k contribute what they must: 1/gamma for trees of k nodes, else nothing.
int order_of_power(StageWeights<Rational>& stages, const std::vector<Rational>& weights, int k, const Rational& slack) {
    for (std::size_t tree = 0; tree < all_trees().size(); ++tree)
        if (abs(missed_by(stages, tree, weights, all_trees().nodes(tree) == k ? 1 : 0)) > slack)
            return all_trees().nodes(tree) - 1;
    return most_order;
}

std::string node_objection(const Tableau& tableau, const NumericTableau<Rational>& numbers, const Rational& slack) {
    if (tableau.c.empty()) return "";
    if (tableau.c.size() != numbers.a.size()) return std::to_string(tableau.c.size()) + " nodes for its rows";
    for (std::size_t i = 0; i < tableau.c.size(); ++i) {
        Rational rest = exact(tableau.c[i]);
        for (const Rational& entry : numbers.a[i]) rest -= entry;
        if (abs(rest) > slack)
            return "row " + std::to_string(i + 1) + " misses its node by " + rest.convert_to<Float100>().str(3);
    }
    return "";
}

}  // namespace

TableauOrders tableau_orders(const NumericTableau<Rational>& tableau, const Rational& slack) {
    if (slack != 0) return tableau_orders(in_100_digits(tableau), slack.convert_to<Float100>());
    return orders_in(tableau, slack);
}

TableauOrders tableau_orders(const NumericTableau<Float100>& tableau, const Float100& slack) {
    return orders_in(tableau, slack);
}

TableauOrders tableau_orders(const Tableau& tableau) { return tableau_orders(exact(tableau), rounding(tableau)); }

int dense_order(const Tableau& tableau) {
    const Rational slack = rounding(tableau);
    const NumericTableau<Rational> numbers = exact(tableau);
    const auto powers = powers_of(tableau.dense);
    if (powers.empty() || !ends_at(numbers.b, powers, slack)) return 0;
    StageWeights<Rational> stages(all_trees(), numbers.a);
    int order = std::min(most_order, static_cast<int>(powers.size()));
    for (std::size_t k = 0; k < powers.size(); ++k)
        order = std::min(order, order_of_power(stages, powers[k], static_cast<int>(k) + 1, slack));
    return order;
}

int butcher_order(const NumericTableau<Rational>& tableau, const Rational& slack) {
    return tableau_orders({tableau.a, tableau.b, {}}, slack).step;
}

std::string orders_objection(const TableauOrders& found, int p, int r) {
    const auto of = [](int order, int declared) { return std::to_string(order) + " of " + std::to_string(declared); };
    if (found.step != p) return "order " + of(found.step, p);
    const bool pair = found.difference > 0;
    if (!pair) return r == 0 ? "" : "declares an estimate and no embedded weights";
    if (r == 0) return "has embedded weights and declares no estimate";
    if (found.difference != r) return "an estimate of order " + of(found.difference, r) + " in h";
    if (r > p + 1) return "the embedded solution does not tell the error from zero";
    return r <= p || found.embedded > p ? "" : "the embedded solution is not better than the one advanced";
}

std::string tableau_objection(const Tableau& tableau, int p, int r) {
    const NumericTableau<Rational> numbers = exact(tableau);
    const Rational slack = rounding(tableau);
    const std::string nodes = node_objection(tableau, numbers, slack * size_of(numbers));
    return nodes.empty() ? orders_objection(tableau_orders(numbers, slack), p, r) : nodes;
}

}  // namespace kreisel::orders
