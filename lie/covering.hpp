// SPDX-License-Identifier: BSD-3-Clause
//
// A covering of a group G: the elements of G with real labels that tell the sheets over G apart, such as the full turns
// of an angle, which an element of G does not record.
#pragma once

#include "lie/group.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// G x R^k, with R^k as a discrete group: labels add, those of the identity are zero, and the algebra is that of G.
/// Neighbours of an element lie on its sheet, so exp, cay and every chart leave labels unchanged: q exp(u) has those of
/// q. They are stored behind the element of G.
class Covering final : public Group {
  public:
    Covering(std::shared_ptr<const Group> base, int labels)
        : Group(base->dim(), base->size() + labels), base_(std::move(base)) {}
    const Group& base() const { return *base_; }
    int factor_dim() const override { return base_->factor_dim(); }

    void identity(Real* q) const override;
    void multiply(const Real* a, const Real* b, Real* out) const override;
    void inverse(const Real* a, Real* out) const override;
    /// Inverse of exp on the sheet of the identity; labels are ignored.
    void log(const Real* q, Real* u) const override { base_->log(q, u); }
    void bracket(const Real* u, const Real* v, Real* out) const override { base_->bracket(u, v, out); }
    void Ad(const Real* q, const Real* v, Real* out) const override { base_->Ad(q, v, out); }
    void coAd(const Real* q, const Real* p, Real* out) const override { base_->coAd(q, p, out); }
    void dexp(const Real* u, const Real* v, Real* out) const override { base_->dexp(u, v, out); }
    void append_exp(const Real* q, const Real* u, Real* out) const override;
    void append_cay(const Real* q, const Real* u, Real* out) const override;
    bool in_exp_chart(const Real* u) const override { return base_->in_exp_chart(u); }
    bool dexpinv_left(const Real* u, const Real* v, Real* out) const override { return base_->dexpinv_left(u, v, out); }
    void dcayinv_left(const Real* u, const Real* v, Real* out) const override { base_->dcayinv_left(u, v, out); }
    bool dexpinv_left_transpose(const Real* u, const Real* p, Real* out) const override {
        return base_->dexpinv_left_transpose(u, p, out);
    }
    void dcayinv_left_transpose(const Real* u, const Real* p, Real* out) const override {
        base_->dcayinv_left_transpose(u, p, out);
    }
    Real orthogonality_defect(const Real* q) const override { return base_->orthogonality_defect(q); }

  private:
    void keep_labels(const Real* q, Real* out) const;

    std::shared_ptr<const Group> base_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
