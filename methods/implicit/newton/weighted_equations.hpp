// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lie/linear.hpp"
#include "lie/status.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// r(x) = 0, as many equations as unknowns, each equation with the unit of its unknown.
class Equations {
  public:
    virtual ~Equations() = default;
    /// Any status but ok ends the iteration with that status.
    virtual Status residual(const Real* x, Real* r) = 0;
    /// After `residual`: size of the weighted unknowns, what their round-off is relative to.
    virtual Real size() const = 0;
    /// Relative round-off of a residual: eps times the condition of its solves.
    virtual Real round_off() const { return epsilon; }
};

inline Real largest_entry(const VecX& values) {
    Real most = 0;
    for (const Real& value : values) most = max(most, Real(abs(value)));
    return most;
}

/// Equations in weighted unknowns w x, all of one unit, with weighted residuals w r.
class WeightedEquations {
  public:
    explicit WeightedEquations(Eigen::Index unknowns) : plain_(unknowns), moved_(unknowns) {}

    /// Both outlive the calls that follow.
    void set(Equations& equations, const VecX& weights) { equations_ = &equations, weights_ = &weights; }
    /// The residual at x; non_finite where an entry is not finite.
    Status residual(const VecX& x, VecX& r) {
        plain_ = x.cwiseQuotient(*weights_);
        return evaluate(r);
    }
    /// p = J s by the difference of r, the residual at x, and that at a point this far from x along s.
    Status difference(const VecX& x, const VecX& r, const VecX& s, const Real& distance, VecX& p) {
        const Real share = distance / largest_entry(s);
        plain_ = (x + share * s).cwiseQuotient(*weights_);
        if (const Status status = evaluate(moved_); status != Status::ok)
            return status == Status::non_finite ? Status::newton_failed : status;
        p = (moved_ - r) / share;
        return Status::ok;
    }

    /// Of the last evaluation: where it was, without weights; Equations::size and round_off; the largest entry.
    const VecX& plain() const { return plain_; }
    const Real& size() const { return size_; }
    void return_to_size(const Real& size) { size_ = size; }  ///< of an earlier evaluation
    const Real& round_off() const { return round_off_; }
    const Real& largest() const { return largest_; }

  private:
    Status evaluate(VecX& r) {
        if (const Status status = equations_->residual(plain_.data(), r.data()); status != Status::ok) return status;
        size_ = equations_->size(), round_off_ = equations_->round_off();
        Real sum = 0;
        largest_ = 0;
        for (Eigen::Index i = 0; i < r.size(); ++i) {
            const Real entry = abs(r[i] *= (*weights_)[i]);
            largest_ = max(largest_, entry);
            sum += entry;
        }
        // NaN and infinity survive a sum, while a comparison with NaN is false and would let it pass.
        return isfinite(sum) ? Status::ok : Status::non_finite;
    }

    Equations* equations_ = nullptr;
    const VecX* weights_ = nullptr;
    VecX plain_, moved_;
    Real size_ = 1, round_off_ = 1, largest_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
