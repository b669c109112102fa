// SPDX-License-Identifier: BSD-3-Clause
//
// Direct product of two groups: every map acts factor by factor.
#pragma once

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <class First, class Second>
struct Pair {
    static constexpr int dim = First::dim + Second::dim, size = First::size + Second::size;
    struct Algebra {
        typename First::Algebra first;
        typename Second::Algebra second;
    };
    struct Element {
        typename First::Element first;
        typename Second::Element second;
    };

    static Element load(const Real* q) { return {First::load(q), Second::load(q + First::size)}; }
    static Algebra load_algebra(const Real* u) {
        return {First::load_algebra(u), Second::load_algebra(u + First::dim)};
    }
    static void save(const Element& g, Real* q) { First::save(g.first, q), Second::save(g.second, q + First::size); }
    static void save_algebra(const Algebra& u, Real* p) {
        First::save_algebra(u.first, p), Second::save_algebra(u.second, p + First::dim);
    }

    static Element identity() { return {First::identity(), Second::identity()}; }
    static Element multiply(const Element& a, const Element& b) {
        return {First::multiply(a.first, b.first), Second::multiply(a.second, b.second)};
    }
    static Element inverse(const Element& a) { return {First::inverse(a.first), Second::inverse(a.second)}; }
    static Algebra bracket(const Algebra& u, const Algebra& v) {
        return {First::bracket(u.first, v.first), Second::bracket(u.second, v.second)};
    }
    static Algebra Ad(const Element& g, const Algebra& v) {
        return {First::Ad(g.first, v.first), Second::Ad(g.second, v.second)};
    }
    static Algebra coAd(const Element& g, const Algebra& p) {
        return {First::coAd(g.first, p.first), Second::coAd(g.second, p.second)};
    }
    static Element exp(const Algebra& u) { return {First::exp(u.first), Second::exp(u.second)}; }
    struct Increment {
        typename First::Increment first;
        typename Second::Increment second;
    };
    static Increment exp_increment(const Algebra& u) {
        return {First::exp_increment(u.first), Second::exp_increment(u.second)};
    }
    static Increment cay_increment(const Algebra& u) {
        return {First::cay_increment(u.first), Second::cay_increment(u.second)};
    }
    static Element append(const Element& g, const Increment& e) {
        return {First::append(g.first, e.first), Second::append(g.second, e.second)};
    }
    static Algebra log(const Element& g) { return {First::log(g.first), Second::log(g.second)}; }
    static Algebra dexp(const Algebra& u, const Algebra& v) {
        return {First::dexp(u.first, v.first), Second::dexp(u.second, v.second)};
    }
    static Algebra dexpinv(const Algebra& u, const Algebra& v) {
        return {First::dexpinv(u.first, v.first), Second::dexpinv(u.second, v.second)};
    }
    static Algebra dexpinv_transpose(const Algebra& u, const Algebra& p) {
        return {First::dexpinv_transpose(u.first, p.first), Second::dexpinv_transpose(u.second, p.second)};
    }
    static Element cay(const Algebra& u) { return {First::cay(u.first), Second::cay(u.second)}; }
    static Algebra dcayinv(const Algebra& u, const Algebra& v) {
        return {First::dcayinv(u.first, v.first), Second::dcayinv(u.second, v.second)};
    }
    static Algebra dcayinv_transpose(const Algebra& u, const Algebra& p) {
        return {First::dcayinv_transpose(u.first, p.first), Second::dcayinv_transpose(u.second, p.second)};
    }
    static Real orthogonality_defect(const Element& g) {
        return First::orthogonality_defect(g.first) + Second::orthogonality_defect(g.second);
    }
    static Real squared_angle(const Algebra& u) {
        return max(First::squared_angle(u.first), Second::squared_angle(u.second));
    }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
