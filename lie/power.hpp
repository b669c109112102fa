// SPDX-License-Identifier: BSD-3-Clause
//
// K^k: k copies of one static kernel, the configuration group of k bodies in one formulation.
#pragma once

#include <concepts>

#include "lie/group.hpp"
#include "lie/linear.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// What a static kernel offers: fixed-size elements and algebra vectors, and the maps of the group as pure functions.
template <class K>
concept Kernel = requires(const typename K::Element& g, const typename K::Algebra& u, const Real* in, Real* out) {
    { K::dim } -> std::convertible_to<int>;                             // dimension of the algebra
    { K::size } -> std::convertible_to<int>;                            // reals that store an element
    { K::load(in) } -> std::same_as<typename K::Element>;               // flat storage to element
    { K::load_algebra(in) } -> std::same_as<typename K::Algebra>;       //
    K::save(g, out);                                                    // element to flat storage
    K::save_algebra(u, out);                                            //
    { K::identity() } -> std::convertible_to<typename K::Element>;      //
    { K::multiply(g, g) } -> std::convertible_to<typename K::Element>;  //
    { K::inverse(g) } -> std::convertible_to<typename K::Element>;      //
    { K::exp(u) } -> std::convertible_to<typename K::Element>;          // one-parameter subgroups
    { K::log(g) } -> std::convertible_to<typename K::Algebra>;          // inverse of exp near the identity
    { K::bracket(u, u) } -> std::convertible_to<typename K::Algebra>;   //
    { K::Ad(g, u) } -> std::convertible_to<typename K::Algebra>;        // exp(Ad_g u) = g exp(u) g^{-1}
    { K::coAd(g, u) } -> std::convertible_to<typename K::Algebra>;      // Ad_g^T on covectors
    { K::dexp(u, u) } -> std::convertible_to<typename K::Algebra>;      // right-trivialised differential of exp
    { K::dexpinv(u, u) } -> std::convertible_to<typename K::Algebra>;   // its inverse
    { K::cay(u) } -> std::convertible_to<typename K::Element>;          // Cayley map
    { K::append(g, K::exp_increment(u)) } -> std::convertible_to<typename K::Element>;  // g + g (exp(u) - 1)
    { K::append(g, K::cay_increment(u)) } -> std::convertible_to<typename K::Element>;  // g + g (cay(u) - 1)
    { K::dcayinv(u, u) } -> std::convertible_to<typename K::Algebra>;  // right-trivialised inverse differential
    { K::dexpinv_transpose(u, u) } -> std::convertible_to<typename K::Algebra>;  // on covectors
    { K::dcayinv_transpose(u, u) } -> std::convertible_to<typename K::Algebra>;  //
    { K::orthogonality_defect(g) } -> std::convertible_to<Real>;                 //
    { K::squared_angle(u) } -> std::convertible_to<Real>;                        // of the rotation part
};

template <Kernel K>
class Power final : public Group {
  public:
    explicit Power(int copies) : Group(copies * K::dim, copies * K::size), copies_(copies) {}
    int factor_dim() const override { return K::dim; }

    void identity(Real* q) const override {
        for (int i = 0; i < copies_; ++i) K::save(K::identity(), q + i * K::size);
    }
    void multiply(const Real* a, const Real* b, Real* out) const override {
        for (int i = 0; i < copies_ * K::size; i += K::size)
            K::save(K::multiply(load_apart(a + i), load_apart(b + i)), out + i);
    }
    void inverse(const Real* a, Real* out) const override {
        for (int i = 0; i < copies_ * K::size; i += K::size) K::save(K::inverse(K::load(a + i)), out + i);
    }
    void log(const Real* q, Real* u) const override {
        for (int i = 0; i < copies_; ++i) K::save_algebra(K::log(K::load(q + i * K::size)), u + i * K::dim);
    }
    void bracket(const Real* u, const Real* v, Real* out) const override {
        for (int i = 0; i < dim(); i += K::dim)
            K::save_algebra(K::bracket(K::load_algebra(u + i), K::load_algebra(v + i)), out + i);
    }
    void Ad(const Real* q, const Real* v, Real* out) const override {
        for (int i = 0; i < copies_; ++i)
            K::save_algebra(K::Ad(K::load(q + i * K::size), K::load_algebra(v + i * K::dim)), out + i * K::dim);
    }
    void coAd(const Real* q, const Real* p, Real* out) const override {
        for (int i = 0; i < copies_; ++i)
            K::save_algebra(K::coAd(K::load(q + i * K::size), K::load_algebra(p + i * K::dim)), out + i * K::dim);
    }
    void dexp(const Real* u, const Real* v, Real* out) const override {
        for (int i = 0; i < dim(); i += K::dim)
            K::save_algebra(K::dexp(K::load_algebra(u + i), K::load_algebra(v + i)), out + i);
    }
    KREISEL_HOT void append_exp(const Real* q, const Real* u, Real* out) const override {
        for (int i = 0; i < copies_; ++i, q += K::size, u += K::dim, out += K::size) {
            const auto increment = K::exp_increment(K::load_algebra(u));  // before q takes up the registers
            K::save(K::append(K::load(q), increment), out);
        }
    }
    KREISEL_HOT void append_cay(const Real* q, const Real* u, Real* out) const override {
        for (int i = 0; i < copies_; ++i, q += K::size, u += K::dim, out += K::size) {
            const auto increment = K::cay_increment(K::load_algebra(u));  // before q takes up the registers
            K::save(K::append(K::load(q), increment), out);
        }
    }
    bool in_exp_chart(const Real* u) const override {
        bool inside = true;
        for (int i = 0; i < dim(); i += K::dim)
            inside &= K::squared_angle(K::load_algebra(u + i)) < largest_squared_angle;
        return inside;
    }
    KREISEL_HOT bool dexpinv_left(const Real* u, const Real* v, Real* out) const override {
        bool inside = true;
        for (int i = 0; i < dim(); i += K::dim) {
            const auto minus_u = negated(u + i);
            inside &= K::squared_angle(minus_u) < largest_squared_angle;
            K::save_algebra(K::dexpinv(minus_u, K::load_algebra(v + i)), out + i);
        }
        return inside;
    }
    KREISEL_HOT void dcayinv_left(const Real* u, const Real* v, Real* out) const override {
        for (int i = 0; i < dim(); i += K::dim)
            K::save_algebra(K::dcayinv(negated(u + i), K::load_algebra(v + i)), out + i);
    }
    KREISEL_HOT bool dexpinv_left_transpose(const Real* u, const Real* p, Real* out) const override {
        bool inside = true;
        for (int i = 0; i < dim(); i += K::dim) {
            const auto minus_u = negated(u + i);
            inside &= K::squared_angle(minus_u) < largest_squared_angle;
            K::save_algebra(K::dexpinv_transpose(minus_u, K::load_algebra(p + i)), out + i);
        }
        return inside;
    }
    KREISEL_HOT void dcayinv_left_transpose(const Real* u, const Real* p, Real* out) const override {
        for (int i = 0; i < dim(); i += K::dim)
            K::save_algebra(K::dcayinv_transpose(negated(u + i), K::load_algebra(p + i)), out + i);
    }
    Real orthogonality_defect(const Real* q) const override {
        Real sum = 0;
        for (int i = 0; i < copies_; ++i) {
            const Real defect = K::orthogonality_defect(load_apart(q + i * K::size));
            sum += defect * defect;
        }
        return sqrt(sum);
    }

  private:
    /// Just below (2 pi)^2 = 39.478...
    static constexpr int largest_squared_angle = 39;

    /// -u: the one place where right-trivialised maps become left-trivialised ones.
    static typename K::Algebra negated(const Real* u) {
        Real minus_u[K::dim];
        for (int i = 0; i < K::dim; ++i) minus_u[i] = -u[i];
        return K::load_algebra(minus_u);
    }

    /// Not merged with the arithmetic: otherwise which products and sums a compiler fuses, and with it the last bits,
    /// depends on the file that instantiates the group.
    [[gnu::noinline]] static typename K::Element load_apart(const Real* q) { return K::load(q); }

    int copies_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
