// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/newton.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Directions kept from the last steps, and the maximum for a stiff system: all, unless there are many unknowns.
constexpr Eigen::Index few_directions = 8, many_unknowns = 512, most_directions = 64;
Eigen::Index directions(Eigen::Index unknowns) { return unknowns <= many_unknowns ? unknowns : most_directions; }
/// Maximum number of steps of any kind, and of Newton steps.
constexpr int most_iterations = 400, most_probes = 40;
/// Bound on the Jacobian, which is near the identity where nothing is stiff.
constexpr int large_gain = 8, steep = 256;
/// In units of round-off: a converged correction, one that no longer decreases, and one too small to give a direction.
constexpr int close = 8, stagnant = 4096, noisy = 1 << 10;

const Real root_of_epsilon = sqrt(epsilon);

Real largest(const VecX& values) {
    Real most = 0;
    for (const Real& value : values) most = max(most, Real(abs(value)));
    return most;
}

}  // namespace

Newton::Newton(Eigen::Index unknowns)
    : H_(unknowns, directions(unknowns)),
      x_(unknowns),
      plain_(unknowns),
      r_(unknowns),
      before_(unknowns),
      best_x_(unknowns),
      best_r_(unknowns),
      g_(unknowns),
      u_(unknowns),
      p_(unknowns),
      rest_(unknowns),
      moved_(unknowns),
      newton_step_(unknowns),
      group_(unknowns, directions(unknowns)) {}

void Newton::forget() {
    H_.clear();
    stiff_ = false, gain_ = 1;
}

Status Newton::solve(Equations& equations, const VecX& weights, Real* x) {
    weights_ = &weights;
    plain_ = Eigen::Map<const VecX>(x, x_.size());
    x_ = plain_.cwiseProduct(weights);
    const Status status = iterate(equations);
    if (status != Status::ok) forget();
    Eigen::Map<VecX>(x, x_.size()) = plain_;
    return status;
}

Status Newton::evaluate(Equations& equations, VecX& r) {
    if (const Status status = equations.residual(plain_.data(), r.data()); status != Status::ok) return status;
    size_ = equations.size(), round_off_ = equations.round_off();
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

Status Newton::iterate(Equations& equations) {
    directions_ = 0;
    if (const Status status = move(equations); status != Status::ok) return status;
    // Size of the guess: without a solution the iteration runs off to where any residual is small beside the unknowns.
    const Real known_to = close * round_off_ * size_;
    Real now = largest(g_), before = 0;  // none yet
    keep_best();
    bool newton_step = false;
    for (int i = 0, probes = 0, slow = 0, still = 0; i < most_iterations && probes <= most_probes; ++i) {
        const bool quiet = max(now, residual_) <= stagnant * round_off_ * size_;
        if (before > 0 && (quiet ? 2 : 4) * now > before) ++(quiet ? still : slow);  // round-off is no slowness
        if (converged(now, before, still, newton_step)) return Status::ok;
        newton_step = slow > (stiff_ ? 0 : 2);
        if (newton_step) {
            if (probes++ == 0) H_.clear();  // the known directions have not helped
            slow = 0;
            if (const Status status = probe(equations); status != Status::ok) return status;
            now = largest(g_);
        }
        before_.swap(r_), before = now;
        const Real residual_before = residual_;
        x_ -= g_;
        const Status status = newton_step && !quiet ? search(equations, before) : move(equations);
        const bool known = status == Status::ok;
        if (newton_step && !known) return status == Status::non_finite ? Status::newton_failed : status;
        if (known) {
            if (!stiff_) learn_from_step(noisy * round_off_ * size_);
            now = largest(g_);
        }
        const bool nearer = known && now < 4 * before && (quiet || residual_ < 16 * residual_before);
        if (newton_step || nearer) {
            keep_best();
        } else {  // away: back to where it was, and from there by a Newton step
            x_ = best_x_, r_ = best_r_, residual_ = largest(r_), size_ = best_size_;
            if (max(before, residual_) <= known_to) return move(equations);  // it is not known better
            before = 0, slow = 3;
            now = std::numeric_limits<Real>::max();
        }
    }
    return Status::newton_failed;
}

/// The Newton step that has led to x_, or the half of it, ..., that makes the correction smaller:
/// H is still that of where it began.
Status Newton::search(Equations& equations, const Real& before) {
    constexpr int most_halvings = 8;
    newton_step_ = g_;
    Real share = 1;
    for (int i = 0;; ++i) {
        const Status status = move(equations);
        if ((status == Status::ok && largest(g_) <= (1 - share / 4) * before) || i == most_halvings) return status;
        share /= 2;
        x_ += share * newton_step_;
    }
}

Status Newton::move(Equations& equations) {
    plain_ = x_.cwiseQuotient(*weights_);
    const Status status = evaluate(equations, r_);
    residual_ = largest_;
    if (status == Status::ok) H_.apply(r_, g_);
    return status;
}

void Newton::keep_best() { best_x_ = x_, best_r_ = r_, best_size_ = size_; }

bool Newton::converged(const Real& now, const Real& before, int still, bool newton_step) const {
    // Away from a solution a large Jacobian makes corrections small, but not the residual.
    const Real most = min(max(root_of_epsilon, Real(stagnant * gain_ * round_off_)), Real(1) / 1024);
    if (!(residual_ <= most * size_)) return false;
    if (now <= close * epsilon * size_) return true;
    if (still > 1 && now <= stagnant * round_off_ * size_) return true;
    if (!(2 * now > before) || !(before > 0)) return false;
    // After a fresh Newton step it is the residual's own round-off, of terms as large as the Jacobian makes them.
    return now <=
           (newton_step ? Real(round_off_ * max(Real(stagnant), Real(close * gain_))) : Real(64 * epsilon)) * size_;
}

void Newton::learn_from_step(const Real& noise) {
    p_ = r_ - before_;
    if (largest(p_) <= noise) return;
    Real length = orthonormalise(8);
    if (!(length > 0)) {
        p_ = r_ - before_;
        length = p_.norm();
        p_ /= length;
    }
    u_ = -g_ / length;
    g_ += p_.dot(r_) * u_;
    H_.add(u_, p_, keep());
}

Real Newton::orthonormalise(int share) {
    const Real whole = p_.norm();
    for (Eigen::Index i = 0; i < min(directions_, keep()); ++i) p_ -= group_.col(i).dot(p_) * group_.col(i);
    const Real length = p_.norm();
    if (!(share * length > whole)) return 0;
    p_ /= length;
    group_.col(directions_++ % keep()) = p_;
    return length;
}

/// Directions of a few steps suffice, except for a stiff system.
Eigen::Index Newton::keep() const {
    return stiff_ || H_.keeps_all() ? group_.cols() : min(few_directions, group_.cols());
}

/// p_ = J g_ by the difference of the residuals at x_ and at a point this far from it.
Status Newton::difference(Equations& equations, const Real& step) {
    const Real share = step / largest(g_);
    plain_ = (x_ + share * g_).cwiseQuotient(*weights_);
    if (const Status status = evaluate(equations, moved_); status != Status::ok)
        return status == Status::non_finite ? Status::newton_failed : status;
    p_ = (moved_ - r_) / share;
    return Status::ok;
}

Status Newton::probe(Equations& equations) {
    stiff_ = true;
    const Real step = sqrt(round_off_) * max(size_, residual_);
    rest_ = r_;
    newton_step_.setZero();
    directions_ = 0;
    Eigen::Index spare = -1;  // the coordinates are taken one after another where the residuals tell no more
    for (Eigen::Index i = 0; i < 3 * group_.cols() && 64 * rest_.norm() > newton_step_.norm(); ++i) {
        spare < 0 ? H_.apply(rest_, g_) : void(g_ = VecX::Unit(g_.size(), spare++));
        if (const Status status = difference(equations, step); status != Status::ok) return status;
        const Real steepness = largest(p_) / largest(g_);
        if (steepness > steep)  // its curvature must not hide what is flat
            if (const Status status = difference(equations, step / steepness); status != Status::ok) return status;
        gain_ = max(gain_, Real(largest(p_) / largest(g_)));
        moved_ = p_;
        const Real length = orthonormalise(256);
        if (!(length > 0)) {
            if (spare < 0 && group_.cols() == g_.size()) spare = 0;
            if (spare < 0 || spare == g_.size()) break;
            continue;
        }
        H_.apply(moved_, u_);
        u_ = (g_ - u_) / length;
        H_.add(u_, p_, keep());
        const Real part = p_.dot(rest_);
        rest_ -= part * p_;
        H_.apply(p_, g_);
        newton_step_ += part * g_;
    }
    H_.apply(rest_, g_);
    g_ += newton_step_;
    stiff_ = gain_ > large_gain;  // else it was an outlier, and updates go on
    return Status::ok;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
