// SPDX-License-Identifier: BSD-3-Clause
//
// Run-time groups against the static kernels; charts against their inverses; output equal to input.
#include "lie/group.hpp"

#include <catch2/catch.hpp>
#include <cstring>

#include "lie/chart.hpp"
#include "lie/covering.hpp"
#include "lie/power.hpp"
#include "tests/lie/dense.hpp"

using namespace kreisel;
using namespace dense;

namespace {

using Body = Pair<Rn<3>, SO3>;

std::vector<std::shared_ptr<const Group>> compounds() {
    const auto bodies = std::make_shared<Power<Body>>(2);
    const auto screws = std::make_shared<Power<SE3>>(2);
    return {bodies, screws, std::make_shared<AdditiveGroup>(5), std::make_shared<TangentGroup>(screws),
            std::make_shared<Covering>(bodies, 2)};
}

VecX element(const Group& group, const VecX& u) {
    VecX q(group.size());
    group.identity(q.data());
    group.append_exp(q.data(), u.data(), q.data());
    return q;
}

}  // namespace

TEST_CASE("every function may write over its input", "[lie]") {
    Random random(12);
    for (const auto& group : compounds()) {
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
    // Small u: the sign of the first bracket dominates, and the remainder is of second order.
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

TEST_CASE("B_3 = 0: three brackets equal two", "[lie]") {
    const Power<SO3> group(1);
    const VecX u = Vec3(Real(1) / 3, 1, Real(-1) / 2), v = Vec3(1, 2, -1);
    VecX two(3), three(3);
    TruncatedExpChart(group, 2).pull_back(u.data(), v.data(), two.data());
    TruncatedExpChart(group, 3).pull_back(u.data(), v.data(), three.data());
    CHECK(two == three);
}

TEST_CASE("labels of a covering add in products and stay as they are along exp and cay", "[lie]") {
    Random random(29);
    const auto base = std::make_shared<Power<Body>>(2);
    const Covering group(base, 2);
    REQUIRE(group.dim() == base->dim());
    REQUIRE(group.size() == base->size() + 2);
    const VecX u = random.vector(group.dim(), 1);
    VecX a = element(group, u), b = element(group, random.vector(group.dim(), 1)), out(group.size());
    CHECK(a.tail(2) == VecX::Zero(2));
    a.tail(2) << 7, -3;
    b.tail(2) << 2, 5;
    const auto has = [&](int first, int second) { return out.tail(2) == (VecX(2) << first, second).finished(); };
    const auto over = [&](auto map) {  // the result of the base group
        VecX expected(base->size());
        map(expected.data());
        return out.head(base->size()) == expected;
    };
    group.append_exp(a.data(), u.data(), out.data());
    CHECK((has(7, -3) && over([&](Real* q) { base->append_exp(a.data(), u.data(), q); })));
    group.append_cay(a.data(), u.data(), out.data());
    CHECK((has(7, -3) && over([&](Real* q) { base->append_cay(a.data(), u.data(), q); })));
    group.multiply(a.data(), b.data(), out.data());
    CHECK((has(9, 2) && over([&](Real* q) { base->multiply(a.data(), b.data(), q); })));
    group.inverse(a.data(), out.data());
    CHECK((has(-7, 3) && over([&](Real* q) { base->inverse(a.data(), q); })));
}
