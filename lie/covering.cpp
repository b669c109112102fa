// SPDX-License-Identifier: BSD-3-Clause
#include "lie/covering.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

void Covering::keep_labels(const Real* q, Real* out) const {
    for (int i = base_->size(); i < size(); ++i) out[i] = q[i];
}

void Covering::identity(Real* q) const {
    base_->identity(q);
    for (int i = base_->size(); i < size(); ++i) q[i] = 0;
}

void Covering::multiply(const Real* a, const Real* b, Real* out) const {
    base_->multiply(a, b, out);
    for (int i = base_->size(); i < size(); ++i) out[i] = a[i] + b[i];
}

void Covering::inverse(const Real* a, Real* out) const {
    base_->inverse(a, out);
    for (int i = base_->size(); i < size(); ++i) out[i] = -a[i];
}

void Covering::append_exp(const Real* q, const Real* u, Real* out) const {
    base_->append_exp(q, u, out);
    keep_labels(q, out);
}

void Covering::append_cay(const Real* q, const Real* u, Real* out) const {
    base_->append_cay(q, u, out);
    keep_labels(q, out);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
