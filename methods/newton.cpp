// SPDX-License-Identifier: BSD-3-Clause
#include "methods/newton.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

constexpr int most_iterations = 50;

/// NaN and infinity survive a sum, while a comparison with NaN is false and would let it pass.
template <class Vector>
bool all_finite(const Vector& values) {
    return isfinite(Real(values.cwiseAbs().sum()));
}

}  // namespace

Newton::Newton(int unknowns)
    : residual_(unknowns),
      moved_(unknowns),
      correction_(unknowns),
      row_weight_(unknowns),
      column_size_(unknowns),
      jacobian_(unknowns, unknowns),
      lu_(unknowns) {}

Status Newton::solve(Equations& equations, const Real* size, Real* x) {
    if (residual_.size() == 0) return Status::ok;
    const Status status = iterate(equations, size, x);
    if (status != Status::ok) forget();
    return status;
}

Status Newton::iterate(Equations& equations, const Real* size, Real* x) {
    const Real round_off = 4096 * epsilon;
    Real previous = 0;  // none yet
    for (int i = 0; i < most_iterations; ++i) {
        if (const Status status = equations.residual(x, residual_.data()); status != Status::ok) return status;
        if (!all_finite(residual_)) return Status::non_finite;
        if (!known_)
            if (const Status status = differentiate(equations, size, x); status != Status::ok) return status;
        residual_.array() *= row_weight_.array();
        correction_ = lu_.solve(residual_);
        correction_.array() *= column_size_.array();
        const Real now = relative_correction(size);
        if (!isfinite(now)) return Status::newton_failed;  // a singular Jacobian
        Eigen::Map<VecX>(x, correction_.size()) -= correction_;
        if (now <= epsilon) return Status::ok;
        if (previous > 0) {
            const Real contraction = now / previous;
            if (contraction < 1 && contraction * now <= epsilon) return Status::ok;
            if (2 * contraction > 1 && now <= round_off) return Status::ok;
            if (4 * contraction > 1) forget();
        }
        previous = now;
    }
    return Status::newton_failed;
}

Status Newton::differentiate(Equations& equations, const Real* size, Real* x) {
    const Real relative_step = sqrt(epsilon);
    for (Eigen::Index j = 0; j < correction_.size(); ++j) {
        const Real at = x[j];
        x[j] += relative_step * size[j];
        const Real step = x[j] - at;  // as it was rounded
        const Status status = equations.residual(x, moved_.data());
        x[j] = at;
        if (status != Status::ok) return status;
        column_size_[j] = size[j];
        jacobian_.col(j) = (moved_ - residual_) * (size[j] / step);
    }
    if (!all_finite(jacobian_)) return Status::non_finite;
    row_weight_ = jacobian_.cwiseAbs().rowwise().maxCoeff().cwiseInverse();
    for (Eigen::Index i = 0; i < row_weight_.size(); ++i) jacobian_.row(i) *= row_weight_[i];
    lu_.compute(jacobian_);
    known_ = true;
    return Status::ok;
}

Real Newton::relative_correction(const Real* size) const {
    Real largest = 0, sum = 0;
    for (Eigen::Index j = 0; j < correction_.size(); ++j) {
        const Real relative = abs(correction_[j]) / size[j];
        largest = max(largest, relative);
        sum += relative;
    }
    return isfinite(sum) ? largest : sum;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
