// SPDX-License-Identifier: BSD-3-Clause
//
// Order conditions of Munthe-Kaas methods with brackets among their stages: stage i and the result are
//   exp(sum_j a_ij K_j + sum c [K_j, K_l]),
// in words of elementary differentials (ordered_forests.hpp), where brackets are commutators of concatenation. Words
// multiply in the order of the left-trivialised product.
#pragma once

#include "tests/judges/conditions/ordered_forests.hpp"

namespace kreisel::orders {

/// x y: words of x followed by words of y.
template <class T>
Series<T> concatenation(const OrderedForests& forests, const Series<T>& x, const Series<T>& y) {
    Series<T> z(forests.size(), T(0));
    for (std::size_t w = 0; w < forests.size(); ++w)
        for (const auto& [head, tail] : forests.splits(w)) z[w] += x[head] * y[forests.find(tail)];
    return z;
}

/// B+(y), the slope at the point y: words of one tree.
template <class T>
Series<T> slope_at(const OrderedForests& forests, const Series<T>& y) {
    Series<T> k(forests.size(), T(0));
    for (std::size_t w = 0; w < forests.size(); ++w)
        if (forests.word(w).size() == 1) k[w] = y[forests.word(w).front()];
    return k;
}

/// sum_m x^m/m! for a series without constant term.
template <class T>
Series<T> exponential_of(const OrderedForests& forests, const Series<T>& x) {
    Series<T> sum = one<T>(forests), power = sum;
    int longest = 0;
    for (std::size_t w = 0; w < forests.size(); ++w) longest = std::max(longest, forests.nodes(w));
    for (int m = 1; m <= longest; ++m) {
        power = concatenation(forests, power, x);
        for (std::size_t w = 0; w < forests.size(); ++w) {
            power[w] /= m;
            sum[w] += power[w];
        }
    }
    return sum;
}

/// sum_j a_j K_j + sum c [K_left, K_right], stages from 0.
template <class T>
struct BracketRow {
    struct Bracket {
        std::size_t left, right;
        T coefficient;
    };
    std::vector<T> weights;
    std::vector<Bracket> brackets;
};
template <class T>
struct BracketMethod {
    std::vector<BracketRow<T>> stages;
    BracketRow<T> result;
};

template <class T>
Series<T> point_of(const OrderedForests& forests, const BracketRow<T>& row, const std::vector<Series<T>>& slopes) {
    Series<T> u(forests.size(), T(0));
    const auto add = [&](const T& factor, const Series<T>& x) {
        for (std::size_t w = 0; w < forests.size(); ++w) u[w] += factor * x[w];
    };
    for (std::size_t j = 0; j < row.weights.size(); ++j) add(row.weights[j], slopes.at(j));
    for (const auto& [left, right, coefficient] : row.brackets) {
        add(coefficient, concatenation(forests, slopes.at(left), slopes.at(right)));
        add(-coefficient, concatenation(forests, slopes.at(right), slopes.at(left)));
    }
    return exponential_of(forests, u);
}

/// One step with h = 1.
template <class T>
Series<T> bracket_series(const OrderedForests& forests, const BracketMethod<T>& method) {
    std::vector<Series<T>> slopes;
    for (const auto& row : method.stages) slopes.push_back(slope_at(forests, point_of(forests, row, slopes)));
    return point_of(forests, method.result, slopes);
}

/// Largest p up to 5 such that method and flow agree on all Lyndon words with up to p nodes.
inline int bracket_order(const BracketMethod<Rational>& method, const Rational& slack) {
    return flow_order(5, slack, [&](const OrderedForests& forests) { return bracket_series(forests, method); });
}

}  // namespace kreisel::orders
