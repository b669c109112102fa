// SPDX-License-Identifier: BSD-3-Clause
//
// How far the two routes to a reference agree.
#pragma once

#include <catch2/catch.hpp>
#include <vector>

#include "engine/reference/taylor/taylor_route.hpp"
#include "engine/report/report.hpp"

namespace reference_tests {

using namespace kreisel;

/// The result of the second route at time t.
struct Taylor {
    std::vector<BodyState> states;
    std::vector<Real> multipliers;
};

inline Taylor taylor(const Model& model, const Real& t) {
    TaylorRoute route(model);
    REQUIRE(route.advance(t, {}) == Status::ok);
    Taylor end{route.states(), {}};
    REQUIRE(route.multipliers(end.multipliers) == Status::ok);
    return end;
}

/// The largest difference of the routes relative to the size of each quantity, which is that of the reference's own
/// errors; multipliers count if the reference has some.
inline Real relative_difference(const ReferenceSolution& a, const Taylor& b) {
    const Distance d = distance(a.states, b.states);
    const auto ratio = [](const Real& x, const Real& y) { return x == 0 ? Real(0) : Real(x / y); };
    const Real states = max(max(ratio(d.position, a.sizes.position), d.rotation),
                            max(ratio(d.velocity, a.sizes.velocity), ratio(d.omega, a.sizes.omega)));
    if (a.multipliers.empty()) return states;
    REQUIRE(a.multipliers.size() == b.multipliers.size());
    const std::vector<Real> none(a.multipliers.size(), Real(0));
    const Real lambda = norm_of_difference(a.multipliers, b.multipliers);
    return max(states, ratio(lambda, norm_of_difference(a.multipliers, none)));
}

}  // namespace reference_tests
