// SPDX-License-Identifier: BSD-3-Clause
//
// The laws of a group and its algebra, for every kind of group and at every place: axioms, exp and log, Ad, brackets,
// orthogonality.
#include "tests/lie/places.hpp"

using namespace places;

namespace {

Real larger(const Real& a, const Real& b) { return !(a <= b) ? a : b; }  // a NaN in `a` stays

}  // namespace

TEST_CASE("the group axioms", "[lie]") {
    holds(to_two_pi, tolerance, [](const Maps& G, const VecX& u, const VecX& v, const VecX& w) {
        const VecX a = G.exp(u), b = G.exp(v), c = G.exp(w), e = G.identity();
        Real defect = (G.multiply(e, a) - a).norm();
        defect = larger((G.multiply(a, e) - a).norm(), defect);
        defect = larger((G.multiply(a, G.inverse(a)) - e).norm(), defect);
        defect = larger((G.multiply(G.inverse(a), a) - e).norm(), defect);
        return larger((G.multiply(G.multiply(a, b), c) - G.multiply(a, G.multiply(b, c))).norm(), defect);
    });
}

TEST_CASE("exp and log", "[lie]") {
    SECTION("exp is a one-parameter subgroup, and appends on the right") {
        holds(to_two_pi, tolerance, [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
            const VecX b = G.exp(v);
            VecX appended(G.g.size());
            G.g.append_exp(b.data(), u.data(), appended.data());
            const Real defect = (G.multiply(G.exp(u / 3), G.exp(2 * u / 3)) - G.exp(u)).norm();
            return larger((appended - G.multiply(b, G.exp(u))).norm(), defect);
        });
    }
    SECTION("cay appends on the right") {
        holds(to_two_pi, tolerance, [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
            const VecX b = G.exp(v);
            VecX appended(G.g.size());
            G.g.append_cay(b.data(), u.data(), appended.data());
            return Real((appended - G.multiply(b, G.cay(u))).norm());
        });
    }
    SECTION("log inverts exp below pi") {
        holds(to_pi, tolerance, [](const Maps& G, const VecX& u, const VecX&, const VecX&) {
            return Real((G.log(G.exp(u)) - u).norm());
        });
    }
    SECTION("exp inverts log everywhere") {
        holds(to_two_pi, tolerance, [](const Maps& G, const VecX& u, const VecX&, const VecX&) {
            return Real((G.exp(G.log(G.exp(u))) - G.exp(u)).norm());
        });
    }
    SECTION("log keeps the digits of tiny vectors") {
        // Relative to 1e-8 as a whole. The rotation part is read off differences of entries of size 1e-8, exact there.
        holds({Place::tiny}, tolerance / 100000000, [](const Maps& G, const VecX& u, const VecX&, const VecX&) {
            return Real((G.log(G.exp(u)) - u).norm());
        });
    }
}

TEST_CASE("Ad", "[lie]") {
    SECTION("is a homomorphism of groups and of algebras") {
        holds(to_two_pi, 4 * tolerance, [](const Maps& G, const VecX& u, const VecX& v, const VecX& w) {
            const VecX a = G.exp(u), b = G.exp(v);
            const Real defect = (G.Ad(G.multiply(a, b), w) - G.Ad(a, G.Ad(b, w))).norm();
            return larger((G.Ad(a, G.bracket(v, w)) - G.bracket(G.Ad(a, v), G.Ad(a, w))).norm(), defect);
        });
    }
    SECTION("moves factors from right to left: a exp(v) = exp(Ad_a v) a") {
        holds(to_two_pi, 4 * tolerance, [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
            const VecX a = G.exp(u);
            return Real((G.multiply(a, G.exp(v)) - G.multiply(G.exp(G.Ad(a, v)), a)).norm());
        });
    }
    SECTION("of exp is exp of ad") {
        holds(to_two_pi, 4 * tolerance, [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
            return Real((G.Ad(G.exp(u), v) - dense::matrix_exp(G.ad(u)) * v).norm());
        });
    }
}

TEST_CASE("the bracket is bilinear, antisymmetric and satisfies the Jacobi identity", "[lie]") {
    holds(to_two_pi, tolerance, [](const Maps& G, const VecX& u, const VecX& v, const VecX& w) {
        Real defect = (G.bracket(u, v) + G.bracket(v, u)).norm();
        defect = larger((G.bracket(u, 2 * v + w) - 2 * G.bracket(u, v) - G.bracket(u, w)).norm(), defect);
        return larger(
            (G.bracket(u, G.bracket(v, w)) + G.bracket(v, G.bracket(w, u)) + G.bracket(w, G.bracket(u, v))).norm(),
            defect);
    });
}

TEST_CASE("rotations stay orthogonal", "[lie]") {
    holds(to_two_pi, 40 * epsilon, [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
        const VecX a = G.exp(u), b = G.cay(u), c = G.exp(v);
        Real defect = larger(G.orthogonality_defect(a), G.orthogonality_defect(b));
        defect = larger(G.orthogonality_defect(G.inverse(a)), defect);
        return larger(G.orthogonality_defect(G.multiply(G.multiply(a, b), c)), defect);
    });
}

TEST_CASE("a false law is refuted at every place except the identity", "[lie][control]") {
    const Named so3 = groups().front();
    for (const Place place : {Place::random, Place::near_pi, Place::near_two_pi}) {
        INFO(name(place));
        CHECK_FALSE(violation(so3, place, tolerance, [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
                        return Real((G.multiply(G.exp(u), G.exp(v)) - G.exp(u + v)).norm());
                    }).empty());
    }
    CHECK_FALSE(violation(so3, Place::identity, tolerance, [](const Maps&, const VecX&, const VecX&, const VecX&) {
                    return std::numeric_limits<Real>::quiet_NaN();
                }).empty());
}
