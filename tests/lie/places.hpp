// SPDX-License-Identifier: BSD-3-Clause
//
// Where the properties of groups are tested: every registered kind of group, and algebra vectors at the identity, at
// 1e-8, at random angles, near rotation by pi and near the end of the chart of exp.
#pragma once

#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <vector>

#include "lie/covering.hpp"
#include "lie/group.hpp"
#include "lie/power.hpp"
#include "tests/lie/dense.hpp"
#include "tests/support/rapid.hpp"

namespace places {

using namespace kreisel;
using dense::tolerance;

/// A group and where its rotation vectors lie in the algebra.
struct Named {
    std::string name;
    std::shared_ptr<const Group> group;
    std::vector<int> rotations;
};

inline std::vector<Named> groups() {
    const auto so3 = std::make_shared<Power<SO3>>(1);
    const auto se3 = std::make_shared<Power<SE3>>(1);
    const auto body = std::make_shared<Power<Pair<Rn<3>, SO3>>>(1);
    return {{"SO(3)", so3, {0}},
            {"SE(3)", se3, {3}},
            {"S^3", std::make_shared<Power<S3>>(1), {0}},
            {"R^3 x S^3", std::make_shared<Power<Pair<Rn<3>, S3>>>(1), {3}},
            {"T*SO(3)", std::make_shared<Power<CotangentSO3>>(1), {0}},
            {"R^3", std::make_shared<Power<Rn<3>>>(1), {}},
            {"R^3 x SO(3)", body, {3}},
            {"SO(3)^2", std::make_shared<Power<SO3>>(2), {0, 3}},
            {"R^5", std::make_shared<AdditiveGroup>(5), {}},
            {"T SE(3)", std::make_shared<TangentGroup>(se3), {3}},
            {"covering of SO(3)^2", std::make_shared<Covering>(std::make_shared<Power<SO3>>(2), 3), {0, 3}},
            {"T of a covering of SE(3)", std::make_shared<TangentGroup>(std::make_shared<Covering>(se3, 2)), {3}},
            {"T (R^3 x SO(3))", std::make_shared<TangentGroup>(body), {3}}};
}

enum class Place { identity, tiny, random, near_pi, near_two_pi };

inline const char* name(Place place) {
    switch (place) {
        case Place::identity:
            return "the identity";
        case Place::tiny:
            return "1e-8";
        case Place::random:
            return "random angles";
        case Place::near_pi:
            return "angles near pi";
        case Place::near_two_pi:
            return "angles near 2 pi";
    }
    return "";
}

/// Angle of a rotation at a place, d in [0, 1] being how far inside: near pi down to 3e-6 from it, near 2 pi up to the
/// end of the chart at sqrt(39).
inline Real angle(Place place, const Real& d) {
    if (place == Place::near_pi) return pi() * (1 - d / 16 - Real(1) / (1 << 20));
    return sqrt(Real(39)) * (1 - d / 32 - Real(1) / (1 << 20));
}

/// The algebra vector at `place` with the direction of `numbers`.
inline VecX vector(const Named& named, Place place, const double* numbers) {
    const int n = named.group->dim();
    VecX u(n);
    for (int i = 0; i < n; ++i) u[i] = Real(numbers[i]);
    if (place == Place::identity) return VecX::Zero(n);
    if (place == Place::tiny) return u / 100000000;
    for (const int r : named.rotations) {
        const Vec3 w = u.segment<3>(r);
        if (w.isZero(0)) continue;
        u.segment<3>(r) = w * (place == Place::random ? Real(3) / 2 : Real(angle(place, abs(w[0])) / w.norm()));
    }
    return u;
}

/// The maps of a group on vectors, by value.
class Maps {
  public:
    explicit Maps(const Group& group) : g(group) {}
    VecX identity() const {
        return element([&](Real* out) { g.identity(out); });
    }
    VecX multiply(const VecX& a, const VecX& b) const {
        return element([&](Real* out) { g.multiply(a.data(), b.data(), out); });
    }
    VecX inverse(const VecX& a) const {
        return element([&](Real* out) { g.inverse(a.data(), out); });
    }
    VecX exp(const VecX& u) const {
        return element([&](Real* out) { g.append_exp(identity().data(), u.data(), out); });
    }
    VecX cay(const VecX& u) const {
        return element([&](Real* out) { g.append_cay(identity().data(), u.data(), out); });
    }
    VecX log(const VecX& a) const {
        return algebra([&](Real* out) { g.log(a.data(), out); });
    }
    VecX bracket(const VecX& u, const VecX& v) const {
        return algebra([&](Real* out) { g.bracket(u.data(), v.data(), out); });
    }
    VecX Ad(const VecX& a, const VecX& v) const {
        return algebra([&](Real* out) { g.Ad(a.data(), v.data(), out); });
    }
    VecX coAd(const VecX& a, const VecX& p) const {
        return algebra([&](Real* out) { g.coAd(a.data(), p.data(), out); });
    }
    VecX dexp(const VecX& u, const VecX& v) const {
        return algebra([&](Real* out) { g.dexp(u.data(), v.data(), out); });
    }
    VecX dexpinv_left(const VecX& u, const VecX& v) const {
        return algebra([&](Real* out) { REQUIRE(g.dexpinv_left(u.data(), v.data(), out)); });
    }
    VecX dcayinv_left(const VecX& u, const VecX& v) const {
        return algebra([&](Real* out) { g.dcayinv_left(u.data(), v.data(), out); });
    }
    VecX dexpinv_left_transpose(const VecX& u, const VecX& p) const {
        return algebra([&](Real* out) { REQUIRE(g.dexpinv_left_transpose(u.data(), p.data(), out)); });
    }
    VecX dcayinv_left_transpose(const VecX& u, const VecX& p) const {
        return algebra([&](Real* out) { g.dcayinv_left_transpose(u.data(), p.data(), out); });
    }
    Real orthogonality_defect(const VecX& a) const { return g.orthogonality_defect(a.data()); }
    /// The matrix of a linear map of the algebra.
    template <class Map>
    MatX matrix(Map map) const {
        MatX A(g.dim(), g.dim());
        for (int i = 0; i < g.dim(); ++i) A.col(i) = map(VecX(VecX::Unit(g.dim(), i)));
        return A;
    }
    /// That of [u, .].
    MatX ad(const VecX& u) const {
        return matrix([&](const VecX& v) { return bracket(u, v); });
    }

    const Group& g;

  private:
    template <class F>
    VecX element(F f) const {
        VecX out(g.size());
        f(out.data());
        return out;
    }
    template <class F>
    VecX algebra(F f) const {
        VecX out(g.dim());
        f(out.data());
        return out;
    }
};

/// A defect of a law at the vector u of the place and further vectors v, w with entries in [-1, 1].
using Law = Real (*)(const Maps&, const VecX& u, const VecX& v, const VecX& w);

#if KREISEL_QUAD
inline constexpr int cases = 10;
#else
inline constexpr int cases = 100;
#endif

/// rapidcheck's report if a law has a defect larger than `limit` for some draw, else nothing.
inline std::string violation(const Named& named, Place place, const Real& limit, Law law) {
    const int n = named.group->dim();
    const Maps maps(*named.group);
    return rapid::counterexample(named.name, 3 * n, cases, [&](const std::vector<double>& numbers) {
        VecX v(n), w(n);
        for (int i = 0; i < n; ++i) v[i] = Real(numbers[static_cast<std::size_t>(n + i)]);
        for (int i = 0; i < n; ++i) w[i] = Real(numbers[static_cast<std::size_t>(2 * n + i)]);
        return law(maps, vector(named, place, numbers.data()), v, w) <= limit;  // false for NaN
    });
}

inline void holds(const std::vector<Place>& where, const Real& limit, Law law) {
    for (const Named& named : groups())
        for (const Place place : where) {
            INFO(named.name << ", at " << name(place));
            const std::string report = violation(named, place, limit, law);
            INFO(report);
            CHECK(report.empty());
        }
}

inline const std::vector<Place> to_pi = {Place::identity, Place::tiny, Place::random, Place::near_pi};
inline const std::vector<Place> to_two_pi = {Place::identity, Place::tiny, Place::random, Place::near_pi,
                                             Place::near_two_pi};

}  // namespace places
