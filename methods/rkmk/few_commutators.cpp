// SPDX-License-Identifier: BSD-3-Clause
#include "methods/rkmk/few_commutators.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/contract/state_space.hpp"
#include "methods/tableaus/bound_tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

struct BoundBracket {
    std::size_t left, right;  // offsets of slopes
    Real coefficient;
};

/// The linear part of a scheme is a tableau, which is checked as one.
Tableau linear_part(const FewCommutatorsScheme& scheme) {
    Tableau tableau;
    for (const BracketSum& row : scheme.stages) tableau.a.push_back(row.weights);
    tableau.b = scheme.result.weights;
    return tableau;
}

/// The brackets of a sum over `before` known slopes, in left trivialisation: with Y = y^{-1}, y' = y k becomes
/// Y' = -k Y, and u becomes -u; of [k_j, k_l] this leaves the sign. The only place where it changes.
std::vector<BoundBracket> left_brackets(const BracketSum& sum, std::size_t before, std::size_t stride) {
    std::vector<BoundBracket> bound;
    for (const BracketTerm& term : sum.brackets) {
        if (std::min(term.left, term.right) < 1 || static_cast<std::size_t>(std::max(term.left, term.right)) > before)
            throw std::invalid_argument("the bracket [k_" + std::to_string(term.left) + ", k_" +
                                        std::to_string(term.right) + "] of a scheme uses more than the " +
                                        std::to_string(before) + " slopes before it");
        bound.push_back({static_cast<std::size_t>(term.left - 1) * stride,
                         static_cast<std::size_t>(term.right - 1) * stride, -value(term.coefficient)});
    }
    return bound;
}

class FewCommutators final : public Integrator {
  public:
    FewCommutators(System& system, const FewCommutatorsScheme& scheme)
        : space_(system),
          group_(space_.group()),
          size_(static_cast<std::size_t>(group_.size())),
          n_(static_cast<std::size_t>(group_.dim())),
          stride_(padded(n_)),
          tableau_(linear_part(scheme), stride_),
          b_brackets_(left_brackets(scheme.result, tableau_.stages(), stride_)),
          u_(stride_),
          bracket_(n_),
          slopes_(stride_ * tableau_.stages()),
          stage_(size_) {
        for (std::size_t i = 0; i < scheme.stages.size(); ++i)
            a_brackets_.push_back(left_brackets(scheme.stages[i], i, stride_));
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        for (std::size_t i = 0; i < tableau_.stages_of_step; ++i) {
            std::copy_n(y, size_, stage_.begin());
            if (!tableau_.a[i].empty()) append(tableau_.a[i], a_brackets_[i], h, stage_.data());
            const Status status = space_.slope(t + tableau_.c[i] * h, stage_.data(), slopes_.data() + i * stride_);
            if (status != Status::ok) return status;
        }
        append(tableau_.b, b_brackets_, h, y);
        return Status::ok;
    }

  private:
    /// y <- y exp(h sum_j a_j K_j + h^2 sum c [K_j, K_l]).
    void append(const Combination& weights, const std::vector<BoundBracket>& brackets, const Real& h, Real* y) {
        combine(weights, h, slopes_.data(), stride_, u_.data());
        for (const BoundBracket& term : brackets) {
            group_.bracket(slopes_.data() + term.left, slopes_.data() + term.right, bracket_.data());
            const Real w = h * h * term.coefficient;
            for (std::size_t k = 0; k < n_; ++k) u_[k] += w * bracket_[k];
            ++work_.brackets;
        }
        group_.append_exp(y, u_.data(), y);
        ++work_.exponentials;
    }

    StateSpace space_;
    const Group& group_;
    std::size_t size_, n_, stride_;
    BoundTableau tableau_;
    std::vector<std::vector<BoundBracket>> a_brackets_;
    std::vector<BoundBracket> b_brackets_;
    std::vector<Real> u_, bracket_, slopes_, stage_;
};

}  // namespace

Factory few_commutators(const FewCommutatorsScheme& scheme) {
    Factory factory;
    factory.make = [scheme](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<FewCommutators>(system, scheme);
    };
    factory.stages = stages_of_step(linear_part(scheme));
    factory.takes_actions = true;
    factory.scheme = Scheme(scheme);
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
