// SPDX-License-Identifier: BSD-3-Clause
//
// Generalised-alpha method on Lie groups in the stabilised index-2 form [arnold2015, sec. 5], [bruels2012],
// [arnold2016]: the steps of generalized_alpha.hpp with
//   D = v + (1/2 - beta) h a + beta h a+ - M^{-1} C(q)^T eta,   Phi(q+) = 0,   C(q+) v+ + b = 0.
// The literature has C(q)^T eta, without M^{-1} (methods/implicit/stabilised_step.hpp says why). All components have
// order 2 from the first step on.
#include "methods/generalized_alpha/generalized_alpha.hpp"
#include "methods/implicit/stabilised_step.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Factory stabilised_alpha() {
    return alpha_factory([](System& system, const OptionValues& options, const MethodDescription&) {
        return std::make_unique<GeneralisedAlpha<StabilisedStep>>(system, alpha_parameters(options));
    });
}

}  // namespace

KREISEL_METHOD(stabilised_alpha(), {.name = "generalized_alpha/index2",
                                    .order = 2,
                                    .cites = {"bruels2012", "arnold2015", "arnold2016", "chunghulbert1993", "gear1985"},
                                    .summary = "generalised-alpha method on Lie groups, stabilised index-2 form",
                                    .variable_cost = true,
                                    .form = Form::implicit,
                                    .reports_multipliers = true,
                                    .meets_positions = true,
                                    .meets_velocities = true,
                                    .keeps_memory = true,
                                    .preserves = {{Property::constraints, Domain::autonomous}}});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
