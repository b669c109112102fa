// SPDX-License-Identifier: BSD-3-Clause
//
// Every static group against its matrices: exp, cay, products, Ad, brackets and dcayinv by their definitions. The laws
// that need no matrices are in laws.cpp and differentials.cpp.
#include <catch2/catch.hpp>

#include "tests/lie/dense.hpp"

using namespace kreisel;
using namespace dense;

using Groups = std::tuple<SO3, S3, SE3, CotangentSO3, Rn<3>, Pair<Rn<3>, SO3>>;

namespace {

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

/// Sizes of the algebra vectors tried; the last rotates by almost pi.
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

}  // namespace

TEMPLATE_LIST_TEST_CASE("exp and cay equal their matrix definitions", "[lie]", Groups) {
    using K = TestType;
    for (const VecX& u : points(K::dim)) {
        CHECK(gap(rep<K>(K::exp(algebra<K>(u))), matrix_exp(rep_algebra<K>(u))) <= tolerance);
        CHECK(gap(rep<K>(K::cay(algebra<K>(u))), matrix_cay(rep_algebra<K>(u))) <= tolerance);
    }
}

TEMPLATE_LIST_TEST_CASE("exp and cay append on the right as their matrices multiply", "[lie]", Groups) {
    using K = TestType;
    auto all = points(K::dim);
    all.push_back(2 * all.back());  // rotates by almost 2 pi
    for (const VecX& u : all) {
        const MatX exp_u = matrix_exp(rep_algebra<K>(u)), cay_u = matrix_cay(rep_algebra<K>(u));
        for (const VecX& v : all) {
            const auto g = K::exp(algebra<K>(v));
            CHECK(gap(rep<K>(K::append(g, K::exp_increment(algebra<K>(u)))), rep<K>(g) * exp_u) <= tolerance);
            CHECK(gap(rep<K>(K::append(g, K::cay_increment(algebra<K>(u)))), rep<K>(g) * cay_u) <= tolerance);
        }
    }
}

TEMPLATE_LIST_TEST_CASE("u = 0 appends nothing, to the last digit", "[lie]", Groups) {
    using K = TestType;
    const VecX zero = VecX::Zero(static_cast<int>(K::dim));
    for (const VecX& v : points(K::dim)) {
        const auto g = K::exp(algebra<K>(v));
        CHECK(rep<K>(K::append(g, K::exp_increment(algebra<K>(zero)))) == rep<K>(g));
        CHECK(rep<K>(K::append(g, K::cay_increment(algebra<K>(zero)))) == rep<K>(g));
    }
}

TEST_CASE("a factor on the left is seen beside one on the right", "[lie][control]") {
    const Mat3 R = SO3::exp(Vec3(1, 2, -1) / 2);
    const Vec3 u = Vec3(2, -1, 3) / 4;
    CHECK(gap(SO3::append(R, SO3::exp_increment(u)), SO3::exp(u) * R) > 1000 * tolerance);
    CHECK(gap(SO3::append(R, SO3::cay_increment(u)), SO3::cay(u) * R) > 1000 * tolerance);
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

TEMPLATE_LIST_TEST_CASE("dcayinv is (I - u/2) v (I + u/2) of the matrices", "[lie]", Groups) {
    using K = TestType;
    const auto all = points(K::dim);
    for (const VecX& u : all)
        for (const VecX& v : all) {
            const MatX U = rep_algebra<K>(u), V = rep_algebra<K>(v), I = MatX::Identity(U.rows(), U.rows());
            const VecX w = flat<K>(K::dcayinv(algebra<K>(u), algebra<K>(v)));
            CHECK(gap(rep_algebra<K>(w), (I - U / 2) * V * (I + U / 2)) <= tolerance);
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
