// SPDX-License-Identifier: BSD-3-Clause
//
// The differentials of exp and cay and their inverses, for every kind of group and at every place: against
// differentiation, against the exponential of ad, left against right, the cut series against its remainder.
#include <Eigen/LU>

#include "lie/chart.hpp"
#include "tests/lie/exact.hpp"
#include "tests/lie/places.hpp"

using namespace places;

namespace {

/// Near 2 pi the inverse differential has a pole: at sqrt(39) it magnifies a rotation by 160, and a translation, where
/// the derivative of the coefficients enters, by 160 squared.
const Real pole = 160 * 160 * tolerance;
const std::vector<Place> at_pole = {Place::near_two_pi};

#if KREISEL_QUAD
const Real e = Real(1) / 100000;
#else
const Real e = Real(1) / 128;
#endif
const Real difference_tolerance = 1000 * sqrt(sqrt(epsilon * epsilon * epsilon));

/// d/ds psi(u + s v) psi(u)^{-1} at s = 0, by differences of sixth order.
template <class Psi>
VecX right_velocity(const Maps& G, Psi psi, const VecX& u, const VecX& v) {
    const VecX inverse = G.inverse(psi(u));
    const auto difference = [&](int k) -> VecX {
        return G.log(G.multiply(psi(u + k * e * v), inverse)) - G.log(G.multiply(psi(u - k * e * v), inverse));
    };
    return (45 * difference(1) - 9 * difference(2) + difference(3)) / (60 * e);
}

/// sum ad_u^k v / (k+1)!, read off the exponential of [ad_u v; 0 0].
VecX dense_dexp(const Maps& G, const VecX& u, const VecX& v) {
    const int n = G.g.dim();
    MatX A = MatX::Zero(n + 1, n + 1);
    A.topLeftCorner(n, n) = G.ad(u);
    A.topRightCorner(n, 1) = v;
    return dense::matrix_exp(A).topRightCorner(n, 1);
}

}  // namespace

TEST_CASE("dexp", "[lie]") {
    SECTION("is the right-trivialised derivative of exp") {
        holds(to_two_pi, difference_tolerance, [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
            const auto exp = [&](const VecX& x) { return G.exp(x); };
            return Real((G.dexp(u, v) - right_velocity(G, exp, u, v)).norm());
        });
    }
    SECTION("is the series in ad to the last digits") {
        holds(to_two_pi, 4 * tolerance, [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
            return Real((G.dexp(u, v) - dense_dexp(G, u, v)).norm());
        });
    }
    SECTION("left and right differ by Ad: dexp_u = Ad_exp(u) dexp_-u") {
        holds(to_two_pi, 4 * tolerance, [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
            return Real((G.dexp(u, v) - G.Ad(G.exp(u), G.dexp(-u, v))).norm());
        });
    }
}

TEST_CASE("dexpinv", "[lie]") {
    const Law inverts = [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
        const Real defect = (G.dexpinv_left(u, G.dexp(-u, v)) - v).norm();
        return max(defect, Real((G.dexp(-u, G.dexpinv_left(u, v)) - v).norm()));
    };
    const Law sides = [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
        return Real((G.dexpinv_left(u, v) - G.dexpinv_left(-u, G.Ad(G.exp(u), v))).norm());
    };
    const Law pulls_back = [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
        // q = exp(u(s)), u' = w, has the left velocity Ad_{q^{-1}} of the right one.
        const auto exp = [&](const VecX& x) { return G.exp(x); };
        const VecX left = G.Ad(G.inverse(G.exp(u)), right_velocity(G, exp, u, v));
        return Real((G.dexpinv_left(u, left) - v).norm());
    };
    SECTION("inverts dexp on either side") { holds(to_pi, tolerance, inverts), holds(at_pole, pole, inverts); }
    SECTION("left and right differ by Ad") { holds(to_pi, 4 * tolerance, sides), holds(at_pole, pole, sides); }
    SECTION("pulls the left velocity of exp(u(s)) back to u'") {
        holds(to_pi, 10 * difference_tolerance, pulls_back);
        holds(at_pole, 160 * 160 * difference_tolerance, pulls_back);
    }
    SECTION("of two brackets at 1e-8 is exact to the third order") {
        holds({Place::tiny}, 4 * epsilon, [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
            const VecX uv = G.bracket(u, v);
            return Real((G.dexpinv_left(u, v) - (v + uv / 2 + G.bracket(u, uv) / 12)).norm());
        });
    }
}

namespace {

VecX second_kind(const Maps& G, const VecX& u) {
    VecX q = G.identity();
    SecondKindChart(G.g).append(q.data(), u.data(), q.data());
    return q;
}

/// u within the chart: no angle is larger than a radian.
VecX in_second_kind(const VecX& u) { return u / max(Real(1), u.cwiseAbs().maxCoeff()); }

}  // namespace

TEST_CASE("coordinates of the second kind", "[lie]") {
    SECTION("are products along the basis of each factor") {
        holds(to_pi, tolerance, [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
            const VecX a = G.exp(v);
            VecX q = a, expected = a;
            SecondKindChart(G.g).append(a.data(), u.data(), q.data());
            for (Eigen::Index k = 0; k < u.size(); ++k)
                expected = G.multiply(expected, G.exp(u[k] * VecX::Unit(u.size(), k)));
            return Real((q - expected).norm());
        });
    }
    SECTION("pull the left velocity of psi(u(s)) back to u'") {
        holds(to_pi, 100 * difference_tolerance, [](const Maps& G, const VecX& any, const VecX& v, const VecX&) {
            const VecX u = in_second_kind(any);
            const auto psi = [&](const VecX& x) { return second_kind(G, x); };
            const VecX left = G.Ad(G.inverse(psi(u)), right_velocity(G, psi, u, v));
            VecX found(v.size());
            REQUIRE(SecondKindChart(G.g).pull_back(u.data(), left.data(), found.data()));
            return Real((found - v).norm());
        });
    }
    SECTION("end where the second angle is a quarter turn") {
        Power<SO3> so3(1);
        const Vec3 inside(3, Real(3) / 2, -2), beyond(3, Real(8) / 5, -2), v(1, 2, 3);
        Vec3 out;
        CHECK(SecondKindChart(so3).pull_back(inside.data(), v.data(), out.data()));
        CHECK_FALSE(SecondKindChart(so3).pull_back(beyond.data(), v.data(), out.data()));
    }
}

TEST_CASE("dcayinv", "[lie]") {
    SECTION("pulls the left velocity of cay(u(s)) back to u'") {
        holds(to_two_pi, 100 * difference_tolerance, [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
            const auto cay = [&](const VecX& x) { return G.cay(x); };
            const VecX left = G.Ad(G.inverse(G.cay(u)), right_velocity(G, cay, u, v));
            return Real((G.dcayinv_left(u, left) - v).norm());
        });
    }
    SECTION("left and right differ by Ad") {
        holds(to_two_pi, 40 * tolerance, [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
            return Real((G.dcayinv_left(u, v) - G.dcayinv_left(-u, G.Ad(G.cay(u), v))).norm());
        });
    }
    SECTION("cay(-u) is the inverse of cay(u)") {
        holds(to_two_pi, 4 * tolerance, [](const Maps& G, const VecX& u, const VecX&, const VecX&) {
            return Real((G.multiply(G.cay(u), G.cay(-u)) - G.identity()).norm());
        });
    }
}

namespace {

/// What the series cut after q brackets leaves out, less its leading term c_p ad^p v; p is the next bracket with a
/// nonzero Bernoulli number. Zero if that lies below the terms that follow, by their norms.
template <int q>
Real remainder_defect(const Maps& G, const VecX& direction, const VecX& v, const Real& factor) {
    constexpr int p = q == 0 ? 1 : q == 1 ? 2 : q + 2;
    static const auto c = exact::left_coefficients(40);
#if KREISEL_QUAD
    const VecX u = direction / 256;
#else
    const VecX u = direction / 16;
#endif
    VecX cut(v.size()), leading = v;
    TruncatedExpChart(G.g, q).pull_back(u.data(), v.data(), cut.data());
    const MatX ad = G.ad(u);
    for (int k = 0; k < p; ++k) leading = ad * leading;
    const Real gap = (G.dexpinv_left(u, v) - cut - factor * exact::real(c[p]) * leading).norm();
    Real power = v.norm(), rest = 20 * epsilon;
    for (int k = 1; k <= 40; ++k) {
        power *= ad.norm();
        if (k > p) rest += abs(exact::real(c[static_cast<std::size_t>(k)])) * power;
    }
    return gap <= rest ? Real(0) : Real(gap / rest);
}

}  // namespace

TEST_CASE("dexpinv cut after q brackets leaves out the next Bernoulli term", "[lie]") {
    const std::vector<Place> where = {Place::identity, Place::tiny, Place::random};
    holds(where, 1,
          [](const Maps& G, const VecX& u, const VecX& v, const VecX&) { return remainder_defect<0>(G, u, v, 1); });
    holds(where, 1,
          [](const Maps& G, const VecX& u, const VecX& v, const VecX&) { return remainder_defect<1>(G, u, v, 1); });
    holds(where, 1,
          [](const Maps& G, const VecX& u, const VecX& v, const VecX&) { return remainder_defect<2>(G, u, v, 1); });
    holds(where, 1,
          [](const Maps& G, const VecX& u, const VecX& v, const VecX&) { return remainder_defect<4>(G, u, v, 1); });
}

TEST_CASE("a remainder of a constant that is off by a tenth is refuted", "[lie][control]") {
    const Law wrong = [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
        return max(remainder_defect<2>(G, u, v, Real(11) / 10), remainder_defect<1>(G, u, v, Real(11) / 10));
    };
    for (const Named& named : groups())
        if (!named.rotations.empty()) CHECK_FALSE(violation(named, Place::random, 1, wrong).empty());
}

TEST_CASE("dexpinv of the wrong side is refuted", "[lie][control]") {
    const Law wrong = [](const Maps& G, const VecX& u, const VecX& v, const VecX&) {
        return Real((G.dexpinv_left(-u, G.dexp(-u, v)) - v).norm());
    };
    for (const Named& named : groups())
        if (!named.rotations.empty())
            for (const Place place : {Place::tiny, Place::random, Place::near_pi})
                CHECK_FALSE(violation(named, place, tolerance, wrong).empty());
}
