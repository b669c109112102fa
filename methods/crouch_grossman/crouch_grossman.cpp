// SPDX-License-Identifier: BSD-3-Clause
#include "methods/crouch_grossman/crouch_grossman.hpp"

#include <algorithm>
#include <utility>

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/contract/state_space.hpp"
#include "methods/tableaus/bound_tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// The products of the solution that a pair is compared with; none where it is not a pair.
Combination embedded_weights(Tableau tableau, std::size_t stride) {
    if (tableau.b_hat.empty()) return {};
    tableau.b = std::exchange(tableau.b_hat, {});
    return BoundTableau(tableau, stride).b;
}

class CrouchGrossman final : public Integrator {
  public:
    CrouchGrossman(System& system, const Tableau& tableau)
        : space_(system),
          group_(space_.group()),
          factor_(static_cast<std::size_t>(group_.dim())),
          tableau_(tableau, factor_.size()),
          b_hat_(embedded_weights(tableau, factor_.size())),
          slopes_(factor_.size() * tableau_.stages()),
          stage_(static_cast<std::size_t>(group_.size())) {}

    Status start(const Real&, const Real*) override {
        first_known_ = false;
        return Status::ok;
    }

    Status step(const Real& t, const Real& h, Real* y) override {
        if (const Status status = stages(0, tableau_.stages_of_step, t, h, y); status != Status::ok) return status;
        append_product(tableau_.b, h, y);
        return Status::ok;
    }

    /// error = log(y^^{-1} y).
    Status attempt(const Real& t, const Real& h, const Real* y, Real* y_new, Real* error) override {
        if (const Status status = stages(first_known_, tableau_.stages(), t, h, y); status != Status::ok) return status;
        first_known_ = true;  // a rejected step starts from here once more
        std::copy_n(y, stage_.size(), y_new);
        append_product(tableau_.b, h, y_new);
        std::copy_n(y, stage_.size(), stage_.begin());
        append_product(b_hat_, h, stage_.data());
        group_.inverse(stage_.data(), stage_.data());
        group_.multiply(stage_.data(), y_new, stage_.data());
        group_.log(stage_.data(), error);
        space_.to_tangent(y_new, error);
        return Status::ok;
    }

    void accept(bool) override { first_known_ = false; }

  private:
    /// The slopes of the stages [first, end).
    Status stages(std::size_t first, std::size_t end, const Real& t, const Real& h, const Real* y) {
        for (std::size_t i = first; i < end; ++i) {
            std::copy_n(y, stage_.size(), stage_.begin());
            append_product(tableau_.a[i], h, stage_.data());
            const Status status =
                space_.slope(t + tableau_.c[i] * h, stage_.data(), slopes_.data() + i * factor_.size());
            if (status != Status::ok) return status;
        }
        return Status::ok;
    }

    /// y <- y exp(h w_1 K_1) ... exp(h w_s K_s).
    void append_product(const Combination& weights, const Real& h, Real* y) {
        for (const Term& term : weights) {
            const Real* K = slopes_.data() + term.offset;
            const Real w = h * term.coefficient;
            for (std::size_t j = 0; j < factor_.size(); ++j) factor_[j] = w * K[j];
            group_.append_exp(y, factor_.data(), y);
            ++work_.exponentials;
        }
    }

    StateSpace space_;
    const Group& group_;
    std::vector<Real> factor_;
    BoundTableau tableau_;
    Combination b_hat_;
    std::vector<Real> slopes_, stage_;
    bool first_known_ = false;  // the first slope is that of the state
};

}  // namespace

Factory crouch_grossman(const Tableau& tableau) {
    Factory factory;
    factory.make = [tableau](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<CrouchGrossman>(system, tableau);
    };
    factory.stages = stages_of_step(tableau);
    factory.takes_actions = true;
    factory.scheme = Scheme(CrouchGrossmanScheme{tableau});
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
