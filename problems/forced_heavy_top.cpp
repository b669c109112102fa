// SPDX-License-Identifier: BSD-3-Clause
//
// The acceptance problem: an asymmetric heavy top in modulated gravity, g(t) = g (1 + A sin(W t)). Its field is state
// dependent, non-commuting and non-autonomous, so wrong nodes, brackets or factor order of a method show; no symmetry
// of the data hides a swapped index. The data are our own, chosen so that orders 1 to 4 are asymptotic from about 64
// steps per second on.
#include "problems/top.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

Model forced_top(const Parameters& p) {
    Model model = top(p);
    model.gravity.amplitude = p.scalar("gravity_amplitude");
    model.gravity.frequency = p.scalar("gravity_frequency");
    return model;
}

std::vector<ParameterDescription> parameters() {
    auto all =
        top_parameters(15, {0.3, 0.05, -0.02, 0.05, 0.5, 0.03, -0.02, 0.03, 0.4}, {0.2, 1, -0.3}, {0.5, 3, -0.4});
    all.push_back({"gravity_amplitude", ParameterKind::scalar, "1", "A in g(t) = g (1 + A sin(W t))", 0.5});
    all.push_back({"gravity_frequency", ParameterKind::scalar, "rad/s", "W in g(t) = g (1 + A sin(W t))", 5.0});
    return all;
}

}  // namespace

KREISEL_PROBLEM(forced_top, {.name = "forced_heavy_top",
                             .summary = "asymmetric heavy top in modulated gravity: the acceptance problem for orders",
                             .cites = {},
                             .parameters = parameters()});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
