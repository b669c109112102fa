// SPDX-License-Identifier: BSD-3-Clause
//
// SO3-LiePoisson: one body that turns about a fixed point, q = R in SO(3), v = omega, as SO3; but steps move the body
// momentum m = J_O omega along its coadjoint orbit with R, m' = ad*_omega m + tau, in place of adding to omega
// (mechanics/actions/coadjoint_action.hpp). Its equations, states and results are those of SO3.
#include "mechanics/actions/coadjoint_action.hpp"
#include "mechanics/formulation.hpp"
#include "mechanics/forwarding_system.hpp"
#include "mechanics/model/pivots.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr const char* lie_poisson = "SO3-LiePoisson";

class LiePoissonBody final : public ForwardingSystem {
  public:
    explicit LiePoissonBody(const Model& model)
        : ForwardingSystem(formulation("SO3").make(model)), action_(action_of(pivoted_bodies(model)[0])) {}
    const StateAction* action() const override { return &action_; }

  private:
    static CoadjointAction action_of(const Pivoted& body) { return {body.J_O, body.J_O_inverse}; }

    CoadjointAction action_;
};

std::string why_no_lie_poisson_body(const Model& model) {
    if (model.bodies.size() != 1) return std::string(lie_poisson) + " takes one body";
    if (!model.torsion_springs.empty())
        return std::string(lie_poisson) + " does not count the turns of torsion springs";
    return why_not_pivoted(model, lie_poisson);
}

}  // namespace

KREISEL_FORMULATION({.name = lie_poisson,
                     .summary = "one body that turns about a fixed point: q = R, v = omega; Runge-Kutta and Adams "
                                "steps move the body momentum along its coadjoint orbit",
                     .place = 6,
                     .cites = {"engofaltinsen2001", "hairer2006"},
                     .why_not = why_no_lie_poisson_body,
                     .make = [](const Model& model) -> std::unique_ptr<System> {
                         return std::make_unique<LiePoissonBody>(model);
                     }});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
