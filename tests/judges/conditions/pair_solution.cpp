// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/conditions/pair_solution.hpp"

#include <Eigen/LU>
#include <boost/multiprecision/eigen.hpp>
#include <stdexcept>

#include "methods/conditions/rooted_trees.hpp"

namespace kreisel::orders {

namespace {

using Of = Entry::Of;
using ConditionVector = Eigen::Matrix<Float100, Eigen::Dynamic, 1>;
using ConditionMatrix = Eigen::Matrix<Float100, Eigen::Dynamic, Eigen::Dynamic>;

/// The conditions on the unknowns of one pair.
class PairConditions {
  public:
    explicit PairConditions(const PublishedPair& pair)
        : pair_(pair), trees_(pair.order), stages_(pair.b.size()), rows_(pair.a.size()) {
        for (std::size_t i = 2; i <= rows_; ++i) add({Of::c, i}, node(i));
        for (std::size_t i = 2; i <= rows_; ++i)
            for (std::size_t j = 2; j < i; ++j) add({Of::a, i, j}, Float100(pair.a[i - 1][j - 1]));
        for (std::size_t i = 1; i <= stages_; ++i) add({Of::b, i}, Float100(pair.b[i - 1]));
        for (std::size_t i = 1; i <= stages_; ++i)
            add({Of::b_hat, i}, Float100(pair.b[i - 1]) - Float100(pair.e[i - 1]));
        for (const ExactEntry& known : pair.exact) start_[index(known.entry)] = known.value;
    }

    const std::vector<Entry>& unknowns() const { return unknowns_; }
    const std::vector<Float100>& start() const { return start_; }
    std::size_t index(const Entry& entry) const {
        return static_cast<std::size_t>(std::find(unknowns_.begin(), unknowns_.end(), entry) - unknowns_.begin());
    }

    NumericTableau<Float100> tableau(const std::vector<Float100>& x) const {
        NumericTableau<Float100> t;
        for (std::size_t i = 0; i < rows_; ++i) t.a.emplace_back(i, Float100(0));
        t.b.resize(stages_), t.b_hat.resize(stages_);
        for (std::size_t k = 0; k < x.size(); ++k) {
            const auto [of, i, j] = unknowns_[k];
            if (of == Of::c) t.a[i - 1][0] += x[k];
            if (of == Of::a) t.a[i - 1][j - 1] = x[k], t.a[i - 1][0] -= x[k];
            if (of == Of::b) t.b[i - 1] = x[k];
            if (of == Of::b_hat) t.b_hat[i - 1] = x[k];
        }
        if (pair_.last_row_is_b) t.a.emplace_back(t.b.begin(), t.b.end() - 1);
        return t;
    }

    /// Of both solutions, one after the other.
    ConditionVector residuals(const std::vector<Float100>& x) const {
        const NumericTableau<Float100> t = tableau(x);
        StageWeights<Float100> stages(trees_, t.a);
        std::vector<Float100> all;
        const auto append = [&](const std::vector<Float100>& weights, int order) {
            for (int n = 1; n <= order; ++n)
                for (const Float100& r : butcher_conditions(stages, weights, n)) all.push_back(r);
        };
        append(t.b, pair_.order);
        append(t.b_hat, pair_.embedded);
        return Eigen::Map<const ConditionVector>(all.data(), static_cast<Eigen::Index>(all.size()));
    }

    /// By one-sided differences, so correct to about 50 digits.
    ConditionMatrix jacobian(std::vector<Float100> x) const {
        const Float100 width("1e-50");
        const ConditionVector here = residuals(x);
        ConditionMatrix J(here.size(), static_cast<Eigen::Index>(x.size()));
        for (std::size_t k = 0; k < x.size(); ++k) {
            const Float100 kept = x[k];
            x[k] += width;
            J.col(static_cast<Eigen::Index>(k)) = (residuals(x) - here) / width;
            x[k] = kept;
        }
        return J;
    }

  private:
    void add(const Entry& entry, const Float100& value) {
        if (value == 0) return;
        unknowns_.push_back(entry);
        start_.push_back(value);
    }

    Float100 node(std::size_t i) const {
        Float100 sum = 0;
        for (const std::string& entry : pair_.a[i - 1]) sum += Float100(entry);
        return sum;
    }

    const PublishedPair& pair_;
    RootedTrees trees_;
    std::size_t stages_, rows_;
    std::vector<Entry> unknowns_;
    std::vector<Float100> start_;
};

/// Those of the columns, in the order given, that do not depend on the ones before.
std::vector<std::size_t> independent(const ConditionMatrix& J, const std::vector<std::size_t>& columns) {
    const Float100 threshold("1e-10");  // columns are dependent to the digits printed, or far from it
    std::vector<std::size_t> found;
    std::vector<ConditionVector> basis;
    for (const std::size_t k : columns) {
        ConditionVector rest = J.col(static_cast<Eigen::Index>(k));
        const Float100 size = rest.norm();
        for (int pass = 0; pass < 2; ++pass)
            for (const ConditionVector& q : basis) rest -= q.dot(rest) * q;
        if (rest.norm() <= threshold * size) continue;
        basis.push_back(rest / rest.norm());
        found.push_back(k);
    }
    return found;
}

/// All unknowns, the ones to be held first last.
std::vector<std::size_t> last_to_hold(const PairConditions& conditions, const std::vector<ExactEntry>& exact) {
    std::vector<std::size_t> first, rest;
    for (const ExactEntry& known : exact) first.push_back(conditions.index(known.entry));
    for (std::size_t k = 0; k < conditions.unknowns().size(); ++k)
        if (std::find(first.begin(), first.end(), k) == first.end()) rest.push_back(k);
    first.insert(first.end(), rest.begin(), rest.end());
    return {first.rbegin(), first.rend()};
}

/// Corrects the unknowns `free` once.
void correct(const PairConditions& conditions, const std::vector<std::size_t>& free, std::vector<Float100>& x) {
    const ConditionMatrix all = conditions.jacobian(x);
    ConditionMatrix J(all.rows(), static_cast<Eigen::Index>(free.size()));
    for (std::size_t k = 0; k < free.size(); ++k)
        J.col(static_cast<Eigen::Index>(k)) = all.col(static_cast<Eigen::Index>(free[k]));
    const ConditionMatrix normal = J.transpose() * J;
    const ConditionVector step = normal.partialPivLu().solve(J.transpose() * conditions.residuals(x));
    for (std::size_t k = 0; k < free.size(); ++k) x[free[k]] -= step[static_cast<Eigen::Index>(k)];
}

}  // namespace

PairSolution solve(const PublishedPair& pair) {
    const PairConditions conditions(pair);
    std::vector<Float100> x = conditions.start();
    const auto free = independent(conditions.jacobian(x), last_to_hold(conditions, pair.exact));
    const auto largest = [&] { return Float100(conditions.residuals(x).cwiseAbs().maxCoeff()); };
    for (int iteration = 0; largest() > Float100("1e-80"); ++iteration) {
        if (iteration == 8) throw std::runtime_error("the conditions of " + pair.method + ": no convergence");
        correct(conditions, free, x);
    }
    PairSolution solution{.tableau = conditions.tableau(x), .held = {}, .moved = 0, .residual = largest()};
    for (std::size_t k = 0; k < x.size(); ++k) {
        const Float100 change = abs(Float100(x[k] - conditions.start()[k]));
        if (change > solution.moved) solution.moved = change;
        if (std::find(free.begin(), free.end(), k) == free.end()) solution.held.push_back(conditions.unknowns()[k]);
    }
    return solution;
}

}  // namespace kreisel::orders
