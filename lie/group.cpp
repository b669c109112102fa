// SPDX-License-Identifier: BSD-3-Clause
#include "lie/group.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

void AdditiveGroup::identity(Real* q) const { std::fill_n(q, dim(), Real(0)); }
void AdditiveGroup::multiply(const Real* a, const Real* b, Real* out) const {
    KREISEL_ELEMENTWISE
    for (int i = 0; i < dim(); ++i) out[i] = a[i] + b[i];
}
void AdditiveGroup::inverse(const Real* a, Real* out) const {
    for (int i = 0; i < dim(); ++i) out[i] = -a[i];
}
void AdditiveGroup::log(const Real* q, Real* u) const { std::copy_n(q, dim(), u); }
void AdditiveGroup::bracket(const Real*, const Real*, Real* out) const { std::fill_n(out, dim(), Real(0)); }
void AdditiveGroup::Ad(const Real*, const Real* v, Real* out) const { std::copy_n(v, dim(), out); }
void AdditiveGroup::coAd(const Real*, const Real* p, Real* out) const { std::copy_n(p, dim(), out); }
void AdditiveGroup::dexp(const Real*, const Real* v, Real* out) const { std::copy_n(v, dim(), out); }
void AdditiveGroup::append_exp(const Real* q, const Real* u, Real* out) const { multiply(q, u, out); }
void AdditiveGroup::append_cay(const Real* q, const Real* u, Real* out) const { multiply(q, u, out); }
bool AdditiveGroup::in_exp_chart(const Real*) const { return true; }
bool AdditiveGroup::dexpinv_left(const Real*, const Real* v, Real* out) const {
    std::copy_n(v, dim(), out);
    return true;
}
void AdditiveGroup::dcayinv_left(const Real*, const Real* v, Real* out) const { std::copy_n(v, dim(), out); }
bool AdditiveGroup::dexpinv_left_transpose(const Real*, const Real* p, Real* out) const {
    std::copy_n(p, dim(), out);
    return true;
}
void AdditiveGroup::dcayinv_left_transpose(const Real*, const Real* p, Real* out) const { std::copy_n(p, dim(), out); }
Real AdditiveGroup::orthogonality_defect(const Real*) const { return 0; }

TangentGroup::TangentGroup(std::shared_ptr<const Group> base)
    : Group(2 * base->dim(), base->size() + base->dim()), base_(std::move(base)), velocities_(base_->dim()) {}

void TangentGroup::identity(Real* y) const { base_->identity(y), velocities_.identity(y + base_->size()); }
void TangentGroup::multiply(const Real* a, const Real* b, Real* out) const {
    const int q = base_->size();
    base_->multiply(a, b, out), velocities_.multiply(a + q, b + q, out + q);
}
void TangentGroup::inverse(const Real* a, Real* out) const {
    base_->inverse(a, out), velocities_.inverse(a + base_->size(), out + base_->size());
}
void TangentGroup::log(const Real* y, Real* z) const {
    base_->log(y, z), velocities_.log(y + base_->size(), z + base_->dim());
}
void TangentGroup::bracket(const Real* u, const Real* v, Real* out) const {
    base_->bracket(u, v, out), velocities_.identity(out + base_->dim());
}
void TangentGroup::Ad(const Real* y, const Real* z, Real* out) const {
    const int n = base_->dim();
    base_->Ad(y, z, out), velocities_.log(z + n, out + n);
}
void TangentGroup::coAd(const Real* y, const Real* p, Real* out) const {
    const int n = base_->dim();
    base_->coAd(y, p, out), velocities_.log(p + n, out + n);
}
void TangentGroup::dexp(const Real* u, const Real* z, Real* out) const {
    const int n = base_->dim();
    base_->dexp(u, z, out), velocities_.log(z + n, out + n);
}
void TangentGroup::append_exp(const Real* y, const Real* u, Real* out) const {
    const int q = base_->size();
    base_->append_exp(y, u, out), velocities_.multiply(y + q, u + base_->dim(), out + q);
}
void TangentGroup::append_cay(const Real* y, const Real* u, Real* out) const {
    const int q = base_->size();
    base_->append_cay(y, u, out), velocities_.multiply(y + q, u + base_->dim(), out + q);
}
bool TangentGroup::in_exp_chart(const Real* u) const { return base_->in_exp_chart(u); }
bool TangentGroup::dexpinv_left(const Real* u, const Real* z, Real* out) const {
    const int n = base_->dim();
    if (out != z) velocities_.log(z + n, out + n);
    return base_->dexpinv_left(u, z, out);
}
void TangentGroup::dcayinv_left(const Real* u, const Real* z, Real* out) const {
    const int n = base_->dim();
    if (out != z) velocities_.log(z + n, out + n);
    base_->dcayinv_left(u, z, out);
}
bool TangentGroup::dexpinv_left_transpose(const Real* u, const Real* p, Real* out) const {
    const int n = base_->dim();
    velocities_.log(p + n, out + n);
    return base_->dexpinv_left_transpose(u, p, out);
}
void TangentGroup::dcayinv_left_transpose(const Real* u, const Real* p, Real* out) const {
    const int n = base_->dim();
    velocities_.log(p + n, out + n);
    base_->dcayinv_left_transpose(u, p, out);
}
Real TangentGroup::orthogonality_defect(const Real* y) const { return base_->orthogonality_defect(y); }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
