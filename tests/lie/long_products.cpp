// SPDX-License-Identifier: BSD-3-Clause
//
// Many factors that are alike, as short steps of a steady motion are: rotations leave the group by the round-off of
// each at random, eps sqrt(N), and not by the same round-off N times.
#include "tests/lie/places.hpp"

namespace long_products {

using namespace places;

namespace {

constexpr int factors = 100000;

/// Angles of a factor, down to those of a step of a microsecond.
const std::vector<double> angles = {1e-6, 1e-5, 1e-3, 1e-2};

VecX factor(const Named& named, double angle) {
    const double direction[] = {0.36, -0.48, 0.8};
    VecX u = VecX::Zero(named.group->dim());
    for (const int r : named.rotations)
        for (int i = 0; i < 3; ++i) u[r + i] = Real(angle * direction[i]);
    return u;
}

/// The largest defect on the way.
template <class Append>
Real defect_of_power(const Named& named, Append append) {
    VecX q = Maps(*named.group).identity();
    Real most = 0;
    for (int i = 0; i < factors; ++i) {
        append(q.data());
        most = max(most, named.group->orthogonality_defect(q.data()));
    }
    return most;
}

Real at_random() { return 2 * epsilon * sqrt(Real(factors)); }

}  // namespace

TEST_CASE("many small factors that are alike leave rotations orthogonal", "[lie][round_off]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    for (const Named& named : groups())
        for (const double angle : angles) {
            INFO(named.name << ", angle " << angle);
            const VecX u = factor(named, angle);
            CHECK(defect_of_power(named, [&](Real* q) { named.group->append_exp(q, u.data(), q); }) <= at_random());
            CHECK(defect_of_power(named, [&](Real* q) { named.group->append_cay(q, u.data(), q); }) <= at_random());
        }
}

TEST_CASE("products by exp(u) and cay(u) leave them", "[lie][round_off][control]") {
    if (KREISEL_QUAD) return;  // slow, and the same code
    const Named so3 = groups().front();
    const Maps maps(*so3.group);
    for (const double angle : angles)
        for (const VecX& turn : {maps.exp(factor(so3, angle)), maps.cay(factor(so3, angle))}) {
            INFO("angle " << angle);
            const auto multiply = [&](Real* q) { so3.group->multiply(q, turn.data(), q); };
            CHECK(defect_of_power(so3, multiply) > 10 * at_random());
        }
}

}  // namespace long_products
