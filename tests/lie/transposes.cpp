// SPDX-License-Identifier: BSD-3-Clause
//
// The transposes of Ad and of the inverse differentials, for every kind of group and at every place, against those of
// their matrices.
#include "tests/lie/places.hpp"

using namespace places;

namespace {

/// As dexpinv itself, near its pole (tests/lie/differentials.cpp).
const Real near_pole = 160 * 160 * tolerance;

Real transpose_defect(const MatX& A, const VecX& p, const VecX& transposed) {
    return (A.transpose() * p - transposed).norm();
}

MatX matrix_of_dexpinv(const Maps& G, const VecX& u) {
    return G.matrix([&](const VecX& v) { return G.dexpinv_left(u, v); });
}

MatX matrix_of_dcayinv(const Maps& G, const VecX& u) {
    return G.matrix([&](const VecX& v) { return G.dcayinv_left(u, v); });
}

Real coadjoint_defect(const Maps& G, const VecX& u, const VecX& p, const VecX&) {
    const VecX a = G.exp(u);
    return transpose_defect(G.matrix([&](const VecX& v) { return G.Ad(a, v); }), p, G.coAd(a, p));
}

Real dexpinv_defect(const Maps& G, const VecX& u, const VecX& p, const VecX&) {
    return transpose_defect(matrix_of_dexpinv(G, u), p, G.dexpinv_left_transpose(u, p));
}

Real dcayinv_defect(const Maps& G, const VecX& u, const VecX& p, const VecX&) {
    return transpose_defect(matrix_of_dcayinv(G, u), p, G.dcayinv_left_transpose(u, p));
}

}  // namespace

TEST_CASE("transposes on covectors", "[lie]") {
    SECTION("of Ad") { holds(to_two_pi, tolerance, coadjoint_defect); }
    SECTION("of dexpinv") {
        holds(to_pi, tolerance, dexpinv_defect);
        holds({Place::near_two_pi}, near_pole, dexpinv_defect);
    }
    SECTION("of dcayinv") { holds(to_two_pi, 40 * tolerance, dcayinv_defect); }
    SECTION("coAd of a product is that of its factors in reverse") {
        holds(to_two_pi, 4 * tolerance, [](const Maps& G, const VecX& u, const VecX& v, const VecX& p) {
            const VecX a = G.exp(u), b = G.exp(v);
            return Real((G.coAd(G.multiply(a, b), p) - G.coAd(b, G.coAd(a, p))).norm());
        });
    }
}

TEST_CASE("a transpose of the other side, and none at all, are refuted", "[lie][control]") {
    const Law sides[] = {[](const Maps& G, const VecX& u, const VecX& p, const VecX&) {
                             return transpose_defect(matrix_of_dexpinv(G, u), p, G.dexpinv_left_transpose(-u, p));
                         },
                         [](const Maps& G, const VecX& u, const VecX& p, const VecX&) {
                             return transpose_defect(matrix_of_dcayinv(G, u), p, G.dcayinv_left_transpose(-u, p));
                         },
                         [](const Maps& G, const VecX& u, const VecX& p, const VecX&) {
                             return transpose_defect(matrix_of_dexpinv(G, u), p, G.dexpinv_left(u, p));
                         }};
    for (const Named& named : groups())
        if (!named.rotations.empty())
            for (const Law& wrong : sides) CHECK_FALSE(violation(named, Place::random, near_pole, wrong).empty());
}

TEST_CASE("on SE(3) a transpose is not the map of the opposite vector, as it is on SO(3)", "[lie][control]") {
    const Law opposite = [](const Maps& G, const VecX& u, const VecX& p, const VecX&) {
        return transpose_defect(matrix_of_dexpinv(G, u), p, G.dexpinv_left(-u, p));
    };
    for (const Named& named : groups()) {
        if (named.name == "SO(3)") CHECK(violation(named, Place::random, tolerance, opposite).empty());
        if (named.name == "SE(3)") CHECK_FALSE(violation(named, Place::random, near_pole, opposite).empty());
    }
}
