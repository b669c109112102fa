// SPDX-License-Identifier: BSD-3-Clause
//
// Run-time groups against the static kernels; charts against what they invert; output equal to input.
#include "lie/group.hpp"

#include <catch2/catch.hpp>
#include <cstring>

#include "lie/chart.hpp"
#include "lie/power.hpp"
#include "tests/lie/dense.hpp"

using namespace kreisel;
using namespace dense;

namespace {

using Body = Pair<Rn<3>, SO3>;

std::vector<std::shared_ptr<const Group>> groups() {
    const auto bodies = std::make_shared<Power<Body>>(2);
    const auto screws = std::make_shared<Power<SE3>>(2);
    return {bodies, screws, std::make_shared<AdditiveGroup>(5),
            std::make_shared<Product>(std::vector<std::shared_ptr<const Group>>{bodies, screws}),
            std::make_shared<TangentGroup>(screws)};
}

VecX element(const Group& group, const VecX& u) {
    VecX q(group.size());
    group.identity(q.data());
    group.append_exp(q.data(), u.data(), q.data());
    return q;
}

Real distance_to_identity(const Group& group, const VecX& q) {
    VecX u(group.dim());
    group.log(q.data(), u.data());
    return u.norm();
}

}  // namespace

TEST_CASE("run-time groups satisfy the group axioms", "[lie]") {
    Random random(11);
    for (const auto& group : groups()) {
        const VecX u = random.vector(group->dim(), 1), v = random.vector(group->dim(), 1);
        const VecX a = element(*group, u), b = element(*group, v);
        VecX product(group->size()), inverse(group->size()), log(group->dim());
        group->inverse(a.data(), inverse.data());
        group->multiply(a.data(), inverse.data(), product.data());
        CHECK(distance_to_identity(*group, product) <= 100 * epsilon);
        group->log(a.data(), log.data());
        CHECK((log - u).norm() <= 400 * epsilon);
        // a exp(v) = a b, and a b = exp(Ad_a v) a.
        VecX appended(group->size()), left(group->size()), turned(group->dim());
        group->append_exp(a.data(), v.data(), appended.data());
        group->multiply(a.data(), b.data(), product.data());
        CHECK((appended - product).norm() <= 100 * epsilon);
        group->Ad(a.data(), v.data(), turned.data());
        left = element(*group, turned);
        group->multiply(left.data(), a.data(), left.data());
        CHECK((left - product).norm() <= 400 * epsilon);
        CHECK(group->orthogonality_defect(product.data()) <= 50 * epsilon);
    }
}

TEST_CASE("every function may write over its input", "[lie]") {
    Random random(12);
    for (const auto& group : groups()) {
        const VecX u = random.vector(group->dim(), 1), v = random.vector(group->dim(), 1);
        const VecX q = element(*group, u);
        const auto same = [](const VecX& a, const VecX& b) { return a == b; };
        const auto algebra_map = [&](auto f) {
            VecX apart(group->dim()), in_place = v;
            f(u.data(), v.data(), apart.data());
            f(u.data(), in_place.data(), in_place.data());
            return same(apart, in_place);
        };
        CHECK(algebra_map([&](auto a, auto b, auto c) { group->bracket(a, b, c); }));
        CHECK(algebra_map([&](auto a, auto b, auto c) { group->dexp(a, b, c); }));
        CHECK(algebra_map([&](auto a, auto b, auto c) { group->dexpinv_left(a, b, c); }));
        CHECK(algebra_map([&](auto a, auto b, auto c) { group->dcayinv_left(a, b, c); }));
        VecX apart(group->size()), in_place = q;
        group->append_exp(q.data(), v.data(), apart.data());
        group->append_exp(in_place.data(), v.data(), in_place.data());
        CHECK(same(apart, in_place));
        in_place = q;
        group->multiply(q.data(), q.data(), apart.data());
        group->multiply(in_place.data(), in_place.data(), in_place.data());
        CHECK(same(apart, in_place));
        in_place = q;
        group->inverse(q.data(), apart.data());
        group->inverse(in_place.data(), in_place.data());
        CHECK(same(apart, in_place));
    }
}

TEST_CASE("dexpinv_left pulls a left-trivialised velocity back: u' = v + 1/2 [u, v] + ...", "[lie]") {
    // Small u: the sign of the first bracket decides, and the remainder is of second order.
    const Power<SO3> group(1);
    const Real size = Real(1) / 1000000;
    const VecX u = size * Vec3(1, 2, 3), v = Vec3(3, -1, 2);
    VecX out(3);
    REQUIRE(group.dexpinv_left(u.data(), v.data(), out.data()));
    const Vec3 bracket = Vec3(u).cross(Vec3(v));
    CHECK((out - v - bracket / 2).norm() <= 100 * size * size);
    CHECK((out - v + bracket / 2).norm() >= bracket.norm() / 2);
}

TEST_CASE("a rotation by 2 pi leaves the chart of exp", "[lie]") {
    const Power<SO3> group(2);
    VecX u = VecX::Zero(6), v = VecX::Ones(6), out(6);
    u[4] = 2 * pi();
    CHECK_FALSE(group.dexpinv_left(u.data(), v.data(), out.data()));
    u[4] = 6;
    CHECK(group.dexpinv_left(u.data(), v.data(), out.data()));
}

TEST_CASE("dexpinv cut after q brackets misses the rest of the series", "[lie]") {
    // Remainder after q brackets: the next nonzero term B_p/p! ad^p v, p = q + 1 or q + 2.
    Random random(13);
    const Power<SE3> group(1);
    const VecX direction = random.vector(6, 1), v = random.vector(6, 1);
    VecX exact(6), cut(6);
#if KREISEL_QUAD
    const Real sizes[] = {Real(1) / 64, Real(1) / 128};
    const std::vector<int> brackets = {0, 1, 2, 4, 6, 8};
#else
    const Real sizes[] = {Real(1) / 8, Real(1) / 16};
    const std::vector<int> brackets = {0, 1, 2, 4};  // the next remainder would lie below round-off
#endif
    for (const int q : brackets) {
        const int next = q == 0 ? 1 : q == 1 ? 2 : q + 2;
        Real remainder[2];
        for (int i = 0; i < 2; ++i) {
            const VecX u = sizes[i] * direction;
            group.dexpinv_left(u.data(), v.data(), exact.data());
            TruncatedExpChart(group, q).pull_back(u.data(), v.data(), cut.data());
            remainder[i] = (exact - cut).norm();
        }
        INFO("q = " << q);
        CHECK(to_double(log2(remainder[0] / remainder[1])) == Approx(next).margin(0.1));
    }
}

TEST_CASE("B_3 = 0: three brackets equal two", "[lie]") {
    const Power<SO3> group(1);
    const VecX u = Vec3(Real(1) / 3, 1, Real(-1) / 2), v = Vec3(1, 2, -1);
    VecX two(3), three(3);
    TruncatedExpChart(group, 2).pull_back(u.data(), v.data(), two.data());
    TruncatedExpChart(group, 3).pull_back(u.data(), v.data(), three.data());
    CHECK(two == three);
}
