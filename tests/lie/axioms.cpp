// SPDX-License-Identifier: BSD-3-Clause
//
// One suite over every static group: its maps against their definitions by dense matrices, at the identity, at 1e-8,
// at random and near rotation by pi.
#include <catch2/catch.hpp>

#include "tests/lie/dense.hpp"

using namespace kreisel;
using namespace dense;

using Groups = std::tuple<SO3, SE3, Rn<3>, Pair<Rn<3>, SO3>>;

namespace {

const Real tolerance = 400 * epsilon;

template <class K>
typename K::Algebra algebra(const VecX& u) {
    return K::load_algebra(u.data());
}

template <class K>
VecX flat(const typename K::Algebra& u) {
    VecX v(static_cast<int>(K::dim));
    K::save_algebra(u, v.data());
    return v;
}

/// Sizes of the algebra vectors the axioms are tried at; the last turns by almost pi.
std::vector<VecX> points(int dim) {
    Random random(17);
    std::vector<VecX> all = {VecX::Zero(dim)};
    for (const Real& size : {Real(1) / 100000000, Real(1) / 1000, Real(1) / 2, Real(1), Real(3) / 2})
        for (int i = 0; i < 4; ++i) all.push_back(random.vector(dim, size));
    VecX near_pi = VecX::Constant(dim, Real(1) / 4);
    near_pi[dim - 1] = pi() * (1 - Real(1) / 1000);
    near_pi.segment(dim - 3, 2).setZero();
    all.push_back(near_pi);
    return all;
}

template <class K>
MatX rep(const typename K::Element& g) {
    return Representation<K>::element(g);
}
template <class K>
MatX rep_algebra(const VecX& u) {
    return Representation<K>::algebra(algebra<K>(u));
}

Real gap(const MatX& a, const MatX& b) { return (a - b).norm() / max(Real(1), Real(b.norm())); }

/// (d/de psi(u + e du)) psi(u)^{-1} by a sixth-order difference, as a matrix: the right-trivialised differential.
template <class Map>
MatX right_differential(const Map& psi, const VecX& u, const VecX& du) {
#if KREISEL_QUAD
    const Real e = Real(1) / 10000;
#else
    const Real e = Real(1) / 128;
#endif
    const auto difference = [&](int k) -> MatX { return psi(u + Real(k) * e * du) - psi(u - Real(k) * e * du); };
    const MatX derivative = (45 * difference(1) - 9 * difference(2) + difference(3)) / (60 * e);
    return derivative * psi(u).inverse();
}

const Real difference_tolerance = sqrt(sqrt(epsilon * epsilon * epsilon)) * 1000;

}  // namespace

TEMPLATE_LIST_TEST_CASE("exp and cay equal their matrix definitions", "[lie]", Groups) {
    using K = TestType;
    for (const VecX& u : points(K::dim)) {
        CHECK(gap(rep<K>(K::exp(algebra<K>(u))), matrix_exp(rep_algebra<K>(u))) <= tolerance);
        CHECK(gap(rep<K>(K::cay(algebra<K>(u))), matrix_cay(rep_algebra<K>(u))) <= tolerance);
    }
}

TEMPLATE_LIST_TEST_CASE("log inverts exp", "[lie]", Groups) {
    using K = TestType;
    for (const VecX& u : points(K::dim)) {
        if (u.tail(3).norm() >= pi()) continue;  // beyond the chart of log
        CHECK((flat<K>(K::log(K::exp(algebra<K>(u)))) - u).norm() <= tolerance * max(Real(1), Real(u.norm())) * 10);
    }
}

TEMPLATE_LIST_TEST_CASE("multiplication, inverse, Ad and bracket are those of the matrices", "[lie]", Groups) {
    using K = TestType;
    const auto all = points(K::dim);
    for (const VecX& u : all)
        for (const VecX& v : all) {
            const auto g = K::exp(algebra<K>(u)), k = K::exp(algebra<K>(v));
            const MatX G = rep<K>(g), V = rep_algebra<K>(v), U = rep_algebra<K>(u);
            CHECK(gap(rep<K>(K::multiply(g, k)), G * rep<K>(k)) <= tolerance);
            CHECK(gap(rep<K>(K::inverse(g)), G.inverse()) <= tolerance);
            CHECK(gap(rep_algebra<K>(flat<K>(K::Ad(g, algebra<K>(v)))), G * V * G.inverse()) <= tolerance);
            CHECK(gap(rep_algebra<K>(flat<K>(K::bracket(algebra<K>(u), algebra<K>(v)))), U * V - V * U) <= tolerance);
        }
}

TEMPLATE_LIST_TEST_CASE("dexp and dcayinv are the differentials of exp and cay", "[lie]", Groups) {
    using K = TestType;
    const auto exp = [](const VecX& u) { return rep<K>(K::exp(algebra<K>(u))); };
    const auto cay = [](const VecX& u) { return rep<K>(K::cay(algebra<K>(u))); };
    const auto all = points(K::dim);
    const VecX du = Random(5).vector(K::dim, 1);
    for (const VecX& u : all) {
        const MatX through_exp = rep_algebra<K>(flat<K>(K::dexp(algebra<K>(u), algebra<K>(du))));
        CHECK(gap(through_exp, right_differential(exp, u, du)) <= difference_tolerance);
        // The right-trivialised velocity of cay(u(t)), pulled back, must be u'.
        const MatX velocity = right_differential(cay, u, du);
        VecX v(static_cast<int>(K::dim));
        for (int i = 0; i < K::dim; ++i) {
            // Coordinates of the velocity in the basis of the algebra, which the representation keeps orthogonal.
            const MatX basis = rep_algebra<K>(VecX::Unit(K::dim, i));
            v[i] = velocity.cwiseProduct(basis).sum() / basis.squaredNorm();
        }
        CHECK((flat<K>(K::dcayinv(algebra<K>(u), algebra<K>(v))) - du).norm() <= 10 * difference_tolerance);
    }
}

TEMPLATE_LIST_TEST_CASE("dexpinv inverts dexp at every angle", "[lie]", Groups) {
    using K = TestType;
    Random random(3);
    for (int i = 0; i < 60; ++i) {
        VecX u = random.vector(K::dim, 1);
        u *= pow(Real(10), -i % 13) / max(Real(u.norm()), epsilon);
        const VecX v = random.vector(K::dim, 1);
        const auto back = K::dexpinv(algebra<K>(u), K::dexp(algebra<K>(u), algebra<K>(v)));
        CHECK((flat<K>(back) - v).norm() <= 50 * epsilon);
    }
}

TEST_CASE("hat and vee are inverse", "[lie]") {
    const Vec3 w(1, -2, Real(1) / 3);
    CHECK(vee(hat(w)) == w);
    CHECK((hat(w) * Vec3(3, 1, 4) - w.cross(Vec3(3, 1, 4))).norm() <= 8 * epsilon);
}

TEST_CASE("log of a rotation by pi has norm pi and reproduces it", "[lie]") {
    for (const Vec3& axis : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 1, 1), Vec3(-1, 2, 3)}) {
        const Mat3 R = SO3::exp(axis * (pi() / axis.norm()));
        const Vec3 u = SO3::log(R);
        CHECK(abs(u.norm() - pi()) <= 16 * epsilon);
        CHECK((SO3::exp(u) - R).norm() <= tolerance);
    }
}
