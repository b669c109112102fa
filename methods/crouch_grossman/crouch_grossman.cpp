// SPDX-License-Identifier: BSD-3-Clause
#include "methods/crouch_grossman/crouch_grossman.hpp"

#include <algorithm>

#include "mechanics/system.hpp"
#include "methods/contract/integrator.hpp"
#include "methods/tableaus/bound_tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

class CrouchGrossman final : public Integrator {
  public:
    CrouchGrossman(System& system, const Tableau& tableau)
        : system_(system),
          factor_(static_cast<std::size_t>(system.state_group().dim())),
          tableau_(tableau, factor_.size()),
          slopes_(factor_.size() * tableau_.stages()),
          stage_(static_cast<std::size_t>(system.state_group().size())) {}

    Status step(const Real& t, const Real& h, Real* y) override {
        for (std::size_t i = 0; i < tableau_.a.size(); ++i) {
            std::copy_n(y, stage_.size(), stage_.begin());
            append_product(tableau_.a[i], h, stage_.data());
            const Status status =
                system_.vector_field(t + tableau_.c[i] * h, stage_.data(), slopes_.data() + i * factor_.size());
            if (status != Status::ok) return status;
        }
        append_product(tableau_.b, h, y);
        return Status::ok;
    }

  private:
    /// y <- y exp(h w_1 K_1) ... exp(h w_s K_s).
    void append_product(const Combination& weights, const Real& h, Real* y) {
        for (const Term& term : weights) {
            const Real* K = slopes_.data() + term.offset;
            const Real w = h * term.coefficient;
            for (std::size_t j = 0; j < factor_.size(); ++j) factor_[j] = w * K[j];
            system_.state_group().append_exp(y, factor_.data(), y);
            ++work_.exponentials;
        }
    }

    System& system_;
    std::vector<Real> factor_;
    BoundTableau tableau_;
    std::vector<Real> slopes_, stage_;
};

}  // namespace

Factory crouch_grossman(const Tableau& tableau) {
    Factory factory;
    factory.make = [tableau](System& system, const OptionValues&, const MethodDescription&) {
        return std::make_unique<CrouchGrossman>(system, tableau);
    };
    factory.stages = static_cast<int>(tableau.b.size());
    factory.scheme = Scheme(CrouchGrossmanScheme{tableau});
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
