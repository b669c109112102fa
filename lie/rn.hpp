// SPDX-License-Identifier: BSD-3-Clause
//
// R^n under addition: the abelian group on which every method must reduce to its classical counterpart.
// exp, log, Ad, dexp, Cayley are all the identity; brackets vanish.
#pragma once

#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

template <int n>
struct Rn {
    static constexpr int dim = n, size = n;
    using Algebra = Eigen::Matrix<Real, n, 1>;
    using Element = Algebra;

    static Element load(const Real* q) { return Eigen::Map<const Element>(q); }
    static Algebra load_algebra(const Real* u) { return load(u); }
    static void save(const Element& x, Real* q) { Eigen::Map<Element>{q} = x; }
    static void save_algebra(const Algebra& u, Real* p) { save(u, p); }

    static Element identity() { return Element::Zero(); }
    static Element multiply(const Element& a, const Element& b) { return a + b; }
    static Element inverse(const Element& a) { return -a; }
    static Algebra bracket(const Algebra&, const Algebra&) { return Algebra::Zero(); }
    static Algebra Ad(const Element&, const Algebra& v) { return v; }
    static Algebra coAd(const Element&, const Algebra& p) { return p; }
    static Element exp(const Algebra& u) { return u; }
    using Increment = Element;
    static Increment exp_increment(const Algebra& u) { return u; }
    static Increment cay_increment(const Algebra& u) { return u; }
    static Element append(const Element& a, const Increment& e) { return a + e; }
    static Algebra log(const Element& x) { return x; }
    static Algebra dexp(const Algebra&, const Algebra& v) { return v; }
    static Algebra dexpinv(const Algebra&, const Algebra& v) { return v; }
    static Algebra dexpinv_transpose(const Algebra&, const Algebra& p) { return p; }
    static Element cay(const Algebra& u) { return u; }
    static Algebra dcayinv(const Algebra&, const Algebra& v) { return v; }
    static Algebra dcayinv_transpose(const Algebra&, const Algebra& p) { return p; }
    static Real orthogonality_defect(const Element&) { return 0; }
    static Real squared_angle(const Algebra&) { return 0; }
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
