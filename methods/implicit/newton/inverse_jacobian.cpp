// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/newton/inverse_jacobian.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// The matrix of few unknowns has rows and columns of zeros behind its own, so that both come in fours.
constexpr Eigen::Index few_unknowns = 48, fours = 4;

}  // namespace

InverseJacobian::InverseJacobian(Eigen::Index unknowns, Eigen::Index most) {
    if (unknowns <= few_unknowns) {
        const Eigen::Index whole = (unknowns + fours - 1) / fours * fours;
        matrix_.setZero(whole, whole);
        return;
    }
    u_.setZero(unknowns, most + 1), p_ = u_;
    order_.reserve(static_cast<std::size_t>(most + 1));
}

void InverseJacobian::clear() {
    matrix_.setZero();
    order_.clear();
}

/// out += (H - I) r, four columns at a time.
void InverseJacobian::add_product(const VecX& r, VecX& out) const {
    Real product[few_unknowns], share[few_unknowns];
    const Eigen::Index whole = matrix_.rows() / fours * fours, n = r.size();  // no rest, as the compiler sees
    for (Eigen::Index i = 0; i < whole; ++i) product[i] = 0, share[i] = i < n ? r[i] : Real(0);
    for (Eigen::Index j = 0; j < whole; j += fours) {
        const Real *a = matrix_.data() + j * whole, *b = a + whole, *c = b + whole, *d = c + whole;
        const Real ra = share[j], rb = share[j + 1], rc = share[j + 2], rd = share[j + 3];
        KREISEL_ELEMENTWISE
        for (Eigen::Index i = 0; i < whole; ++i) product[i] += (ra * a[i] + rb * b[i]) + (rc * c[i] + rd * d[i]);
    }
    for (Eigen::Index i = 0; i < n; ++i) out[i] += product[i];
}

void InverseJacobian::apply(const VecX& r, VecX& out) const {
    out = r;
    if (keeps_all()) return add_product(r, out);
    for (const Eigen::Index i : order_) out += p_.col(i).dot(r) * u_.col(i);
}

void InverseJacobian::add(const VecX& u, const VecX& p, Eigen::Index keep) {
    if (keeps_all()) {
        for (Eigen::Index j = 0; j < p.size(); ++j) {
            const Real share = p[j];
            Real* const column = matrix_.data() + j * matrix_.rows();
            KREISEL_ELEMENTWISE
            for (Eigen::Index i = 0; i < u.size(); ++i) column[i] += share * u[i];
        }
        return;
    }
    Eigen::Index free = 0;
    while (std::find(order_.begin(), order_.end(), free) != order_.end()) ++free;
    u_.col(free) = u, p_.col(free) = p;
    order_.push_back(free);
    while (static_cast<Eigen::Index>(order_.size()) > min(keep, u_.cols() - 1)) drop_oldest();
}

/// H -= u w^T for the oldest pair, w being the part of its p orthogonal to the others.
void InverseJacobian::drop_oldest() {
    auto p = p_.col(order_.front());
    const auto u = u_.col(order_.front());
    for (std::size_t k = order_.size(); k-- > 1;) {
        const Eigen::Index i = order_[k];
        const Real share = p_.col(i).dot(p);
        u_.col(i) += share * u;
        p -= share * p_.col(i);
    }
    order_.erase(order_.begin());
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
