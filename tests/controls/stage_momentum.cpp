// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/system.hpp"
#include "methods/variational/rattle_family.hpp"
#include "tests/controls/broken.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// (d tau^{-1}_u)^T p = p - 1/2 ad_u^T p + ..., cut there.
class StageMomentum final : public RattleEquations {
  public:
    explicit StageMomentum(System& system) : RattleEquations(system, IncrementChart::exp), group_(system.group()) {}

  private:
    bool pull_back(const VecX& u, const VecX& p, VecX& out) const override {
        VecX bracket(u.size()), moved = p;
        for (Eigen::Index i = 0; i < u.size(); ++i) {
            group_.bracket(u.data(), VecX(VecX::Unit(u.size(), i)).data(), bracket.data());
            moved[i] -= p.dot(bracket) / 2;
        }
        out = moved;
        return true;
    }

    const Group& group_;
};

}  // namespace

Factory rattlie_with_stage_momentum() {
    Factory factory;
    factory.make = [](System& system, const OptionValues&, const MethodDescription&) {
        return make_rattlie(system, std::make_unique<StageMomentum>(system));
    };
    factory.declines = method("variational/rattlie").factory.declines;
    return factory;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
