// SPDX-License-Identifier: BSD-3-Clause
//
// Ordered forests and series over them, from which the order conditions of products of exponentials are generated.
//
// Let K be the slope of y' = y F(y) at a point. A method that moves along frozen slopes has the pull-back
//   f(y exp(K_1) exp(K_2) ...) = (exp(K_1) exp(K_2) ... f)(y),
// a series in words of elementary differentials. Those are planar (ordered) rooted trees: B+(w), the tree whose root
// carries the trees of the word w in their order, stands for w applied to F. With concatenation as the product,
//   method   Y_i = prod_j exp(a_ij K_j),  K_i = B+(Y_i),  Y = prod_j exp(b_j K_j),  j ascending;
//   flow     Y' = Y B+(Y),  Y(0) = 1;
// and order p means that both agree on all words with up to p nodes [owrenmarthinsen1999]. Words multiply in the order
// of the factors of the left-trivialised product. For Y' = A(Y) Y all words and all products are reversed, which
// leaves the conditions as they are.
//
// Both series are characters of the shuffle product, so their values on Lyndon words determine all others: these are
// the independent conditions, 1, 1, 3, 8, 25 for orders 1 to 5.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "methods/conditions/numeric_tableau.hpp"

namespace kreisel::orders {

/// All ordered forests with up to `order` nodes. A tree is named by the index of the forest of its branches, so B+ is
/// the identity on indices; index 0 is the empty forest, and as a tree the single node.
class OrderedForests {
  public:
    using Tree = std::size_t;
    using Word = std::vector<Tree>;
    struct Split {
        std::size_t head;  ///< index of the leading trees
        Word tail;         ///< the trees that follow
    };

    explicit OrderedForests(int order);

    std::size_t size() const { return words_.size(); }
    const Word& word(std::size_t forest) const { return words_[forest]; }
    /// Index of a word. Throws std::out_of_range for one with more than `order` nodes.
    std::size_t find(const Word& word) const { return index_.at(word); }
    int nodes(std::size_t forest) const { return nodes_[forest]; }
    /// All ways to cut the word in two, empty parts included.
    const std::vector<Split>& splits(std::size_t forest) const { return splits_[forest]; }
    /// Forests with exactly n nodes: 1, 2, 5, 14, 42, ...
    std::vector<std::size_t> of_order(int n) const;
    /// Those of them that are Lyndon words in the alphabet of trees: 1, 1, 3, 8, 25, ...
    std::vector<std::size_t> lyndon(int n) const;

  private:
    void add(const Word& word, int nodes);

    std::vector<Word> words_;
    std::vector<int> nodes_;
    std::vector<std::vector<Split>> splits_;
    std::map<Word, std::size_t> index_;
};

/// One coefficient per forest.
template <class T>
using Series = std::vector<T>;

template <class T>
Series<T> one(const OrderedForests& forests) {
    Series<T> y(forests.size(), T(0));
    y[0] = 1;
    return y;
}

/// Coefficient of exp(a B+(y)) at a word t_1 ... t_m: a^m/m! y(t_1) ... y(t_m).
template <class T>
T exponential(const T& a, const Series<T>& y, const OrderedForests::Word& word) {
    T product = 1;
    for (std::size_t m = 0; m < word.size(); ++m) product *= a * y[word[m]] / static_cast<int>(m + 1);
    return product;
}

/// x exp(a B+(y)).
template <class T>
Series<T> append_exponential(const OrderedForests& forests, const Series<T>& x, const T& a, const Series<T>& y) {
    Series<T> z(forests.size(), T(0));
    for (std::size_t w = 0; w < forests.size(); ++w)
        for (const auto& [head, tail] : forests.splits(w)) z[w] += x[head] * exponential(a, y, tail);
    return z;
}

/// Order of the factors in a product over the stages; the Crouch-Grossman method has `ascending` throughout.
enum class Factors { ascending, descending };

/// prod_j exp(weight_j B+(stage_j)).
template <class T>
Series<T> product(const OrderedForests& forests, const std::vector<T>& weights, const std::vector<Series<T>>& stages,
                  Factors order = Factors::ascending) {
    Series<T> y = one<T>(forests);
    for (std::size_t k = 0; k < weights.size(); ++k) {
        const std::size_t j = order == Factors::ascending ? k : weights.size() - 1 - k;
        y = append_exponential(forests, y, weights[j], stages[j]);
    }
    return y;
}

/// One step of the Crouch-Grossman method with h = 1; other orders of its factors are for comparison.
template <class T>
Series<T> crouch_grossman_series(const OrderedForests& forests, const NumericTableau<T>& tableau,
                                 Factors stage_factors = Factors::ascending,
                                 Factors final_factors = Factors::ascending) {
    std::vector<Series<T>> stages;
    for (const auto& row : tableau.a) stages.push_back(product(forests, row, stages, stage_factors));
    return product(forests, tableau.b, stages, final_factors);
}

/// The exact flow at time 1: n Y(w) = Y(head) Y(last tree) for a word w with n nodes.
template <class T>
Series<T> exact_series(const OrderedForests& forests) {
    Series<T> y = one<T>(forests);
    for (std::size_t w = 1; w < forests.size(); ++w) {
        const auto& splits = forests.splits(w);
        const auto& [head, last] = splits[splits.size() - 2];
        y[w] = y[head] * y[last[0]] / forests.nodes(w);
    }
    return y;
}

/// Largest p up to `most` such that series_of(forests) and the flow agree within `slack` on the Lyndon words with up to
/// p nodes.
template <class F>
int flow_order(int most, const Rational& slack, F series_of) {
    for (int order = 1; order <= most; ++order) {
        const OrderedForests forests(order);
        const Series<Rational> method = series_of(forests), flow = exact_series<Rational>(forests);
        for (const std::size_t w : forests.lyndon(order))
            if (abs(method[w] - flow[w]) > slack) return order - 1;
    }
    return most;
}

}  // namespace kreisel::orders
