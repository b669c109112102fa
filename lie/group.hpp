// SPDX-License-Identifier: BSD-3-Clause
//
// Groups whose size is known at run time: flat, contiguous storage over the static kernels of so3.hpp, se3.hpp, ...
// One virtual call covers all bodies. Output may be the same storage as input, in every function.
#pragma once

#include <memory>
#include <vector>

#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A Lie group G with algebra g = R^dim. Elements are `size` reals, algebra elements `dim` reals.
class Group {
  public:
    Group(int dim, int size) : dim_(dim), size_(size) {}
    virtual ~Group() = default;
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;

    int dim() const { return dim_; }
    int size() const { return size_; }

    /// The algebra is a direct sum of ideals of this dimension, one after another: those of the bodies.
    virtual int factor_dim() const { return dim(); }

    virtual void identity(Real* q) const = 0;
    virtual void multiply(const Real* a, const Real* b, Real* out) const = 0;
    virtual void inverse(const Real* a, Real* out) const = 0;
    virtual void log(const Real* q, Real* u) const = 0;
    virtual void bracket(const Real* u, const Real* v, Real* out) const = 0;
    virtual void Ad(const Real* q, const Real* v, Real* out) const = 0;
    /// out = Ad_q^T p for a covector p in R^dim, whose value at v is p . v. The coadjoint action of q is coAd of
    /// q^{-1}.
    virtual void coAd(const Real* q, const Real* p, Real* out) const = 0;
    /// dexp_u(v), right-trivialised as in the literature.
    virtual void dexp(const Real* u, const Real* v, Real* out) const = 0;

    /// out = q exp(u): factors append on the right. Groups of rotations add q (exp(u) - 1) to q: in 1 - |u|^2/2 + ...
    /// the last digits of the small part are lost, alike in steps that are alike, and products would scale q.
    virtual void append_exp(const Real* q, const Real* u, Real* out) const = 0;
    /// out = q cay(u), in the same way.
    virtual void append_cay(const Real* q, const Real* u, Real* out) const = 0;
    /// Whether u lies inside the chart of exp: every rotation by less than 2 pi, where dexpinv has its pole.
    virtual bool in_exp_chart(const Real* u) const = 0;
    /// Left-trivialised inverse differential of exp: out = dexp^{-1}_{-u}(v) = v + 1/2 [u, v] + 1/12 [u, [u, v]] - ...
    /// False if u lies outside the chart.
    virtual bool dexpinv_left(const Real* u, const Real* v, Real* out) const = 0;
    /// Left-trivialised inverse differential of cay: out = dcay^{-1}_{-u}(v).
    virtual void dcayinv_left(const Real* u, const Real* v, Real* out) const = 0;
    /// The transposes of these maps, on covectors p; variational methods carry momenta with them.
    virtual bool dexpinv_left_transpose(const Real* u, const Real* p, Real* out) const = 0;
    virtual void dcayinv_left_transpose(const Real* u, const Real* p, Real* out) const = 0;

    /// sqrt of the sum over rotation factors of |R^T R - I|^2 (Frobenius).
    virtual Real orthogonality_defect(const Real* q) const = 0;

  private:
    int dim_, size_;
};

/// R^n with n known at run time.
class AdditiveGroup final : public Group {
  public:
    explicit AdditiveGroup(int n) : Group(n, n) {}
    int factor_dim() const override { return 1; }
    void identity(Real* q) const override;
    void multiply(const Real* a, const Real* b, Real* out) const override;
    void inverse(const Real* a, Real* out) const override;
    void log(const Real* q, Real* u) const override;
    void bracket(const Real* u, const Real* v, Real* out) const override;
    void Ad(const Real* q, const Real* v, Real* out) const override;
    void coAd(const Real* q, const Real* p, Real* out) const override;
    void dexp(const Real* u, const Real* v, Real* out) const override;
    void append_exp(const Real* q, const Real* u, Real* out) const override;
    void append_cay(const Real* q, const Real* u, Real* out) const override;
    bool in_exp_chart(const Real* u) const override;
    bool dexpinv_left(const Real* u, const Real* v, Real* out) const override;
    void dcayinv_left(const Real* u, const Real* v, Real* out) const override;
    bool dexpinv_left_transpose(const Real* u, const Real* p, Real* out) const override;
    void dcayinv_left_transpose(const Real* u, const Real* p, Real* out) const override;
    Real orthogonality_defect(const Real* q) const override;
};

/// The state space TG = G x R^n of a configuration group G: element y = (q, v), algebra z = (q^{-1} q', v'). The
/// velocity factor is additive, so its brackets vanish and only the factor G needs dexpinv [terzezlatarmueller, eq. 7].
class TangentGroup final : public Group {
  public:
    explicit TangentGroup(std::shared_ptr<const Group> base);
    const Group& base() const { return *base_; }
    /// The velocity part of an element y = (q, v), and of an algebra element z = (v, v').
    const Real* v(const Real* y) const { return y + base_->size(); }
    Real* v(Real* y) const { return y + base_->size(); }
    const Real* dv(const Real* z) const { return z + base_->dim(); }
    Real* dv(Real* z) const { return z + base_->dim(); }

    void identity(Real* y) const override;
    void multiply(const Real* a, const Real* b, Real* out) const override;
    void inverse(const Real* a, Real* out) const override;
    void log(const Real* y, Real* z) const override;
    void bracket(const Real* u, const Real* v, Real* out) const override;
    void Ad(const Real* y, const Real* z, Real* out) const override;
    void coAd(const Real* y, const Real* p, Real* out) const override;
    void dexp(const Real* u, const Real* z, Real* out) const override;
    void append_exp(const Real* y, const Real* u, Real* out) const override;
    void append_cay(const Real* y, const Real* u, Real* out) const override;
    bool in_exp_chart(const Real* u) const override;
    bool dexpinv_left(const Real* u, const Real* z, Real* out) const override;
    void dcayinv_left(const Real* u, const Real* z, Real* out) const override;
    bool dexpinv_left_transpose(const Real* u, const Real* p, Real* out) const override;
    void dcayinv_left_transpose(const Real* u, const Real* p, Real* out) const override;
    Real orthogonality_defect(const Real* y) const override;

  private:
    std::shared_ptr<const Group> base_;
    AdditiveGroup velocities_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
