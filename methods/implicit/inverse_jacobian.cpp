// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/inverse_jacobian.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr Eigen::Index few_unknowns = 48;

}  // namespace

InverseJacobian::InverseJacobian(Eigen::Index unknowns, Eigen::Index most) {
    if (unknowns <= few_unknowns) {
        matrix_.setZero(unknowns, unknowns);
        return;
    }
    u_.setZero(unknowns, most + 1), p_ = u_;
    order_.reserve(static_cast<std::size_t>(most + 1));
}

void InverseJacobian::clear() {
    matrix_.setZero();
    order_.clear();
}

void InverseJacobian::apply(const VecX& r, VecX& out) const {
    out = r;
    const Eigen::Index n = matrix_.cols();
    Real* const to = out.data();
    const Real* column = matrix_.data();
    for (Eigen::Index j = 0; j < n; ++j, column += n) {
        const Real share = r[j];
        KREISEL_ELEMENTWISE
        for (Eigen::Index i = 0; i < n; ++i) to[i] += share * column[i];
    }
    for (const Eigen::Index i : order_) out += p_.col(i).dot(r) * u_.col(i);
}

void InverseJacobian::add(const VecX& u, const VecX& p, Eigen::Index keep) {
    for (Eigen::Index j = 0; j < matrix_.cols(); ++j) matrix_.col(j) += p[j] * u;
    if (u_.cols() == 0) return;
    Eigen::Index free = 0;
    while (std::find(order_.begin(), order_.end(), free) != order_.end()) ++free;
    u_.col(free) = u, p_.col(free) = p;
    order_.push_back(free);
    while (static_cast<Eigen::Index>(order_.size()) > min(keep, u_.cols() - 1)) drop_oldest();
}

/// H -= u w^T for the oldest pair, w being what of its p is orthogonal to those of the others.
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
