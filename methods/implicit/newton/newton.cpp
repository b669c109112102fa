// SPDX-License-Identifier: BSD-3-Clause
#include "methods/implicit/newton/newton.hpp"

#include <algorithm>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Directions kept from the last steps, and the maximum for a stiff system: all, unless there are many unknowns.
constexpr Eigen::Index few_directions = 8, many_unknowns = 512, most_directions = 64;
Eigen::Index room_for_directions(Eigen::Index unknowns) {
    return unknowns <= many_unknowns ? unknowns : most_directions;
}
/// Maximum number of steps of any kind, and of Newton steps.
constexpr int most_iterations = 400, most_newton_steps = 40;
/// Of the Jacobian, which is near the identity where nothing is stiff.
constexpr int large_gain = 8;
/// In units of round-off: a converged correction, one that no longer decreases, and one too small to give a direction.
constexpr int close = 8, stagnant = 4096, noisy = 1 << 10;

const Real root_of_epsilon = sqrt(epsilon);

}  // namespace

Newton::Newton(Eigen::Index unknowns)
    : equations_(unknowns),
      H_(unknowns, room_for_directions(unknowns)),
      directions_(unknowns, room_for_directions(unknowns)),
      newton_(unknowns),
      x_(unknowns),
      r_(unknowns),
      before_(unknowns),
      best_x_(unknowns),
      best_r_(unknowns),
      g_(unknowns),
      u_(unknowns),
      p_(unknowns),
      back_(unknowns) {}

void Newton::forget() {
    H_.clear(), newton_.forget();
    stiff_ = false;
}

Status Newton::solve(Equations& equations, const VecX& weights, Real* x) {
    equations_.set(equations, weights);
    x_ = Eigen::Map<const VecX>(x, x_.size()).cwiseProduct(weights);
    const Status status = iterate();
    if (status != Status::ok) forget();
    Eigen::Map<VecX>(x, x_.size()) = equations_.plain();
    return status;
}

Status Newton::iterate() {
    directions_.clear();
    if (const Status status = evaluate(); status != Status::ok) return status;
    // Size of the guess: without a solution the iteration runs off to where any residual is small beside the unknowns.
    const Real known_to = round_off(close), small = root_of_epsilon * equations_.size();
    Progress progress{.correction = largest_entry(g_)};
    keep_best();
    for (int i = 0; i < most_iterations && progress.newton_steps <= most_newton_steps; ++i) {
        assess(progress);
        if (converged(progress)) {
            if (progress.newton_steps > 0 || !hides_residual(progress)) return Status::ok;
            progress.slow = 3;
        }
        progress.newton_step = progress.slow > (stiff_ ? 0 : 2);
        if (progress.newton_step)
            if (const Status status = plan_newton_step(progress); status != Status::ok) return status;
        progress.before = progress.correction, progress.residual_before = residual_;
        const Status status = take_step(progress);
        const bool known = status == Status::ok;
        if (progress.newton_step && !known) return status == Status::non_finite ? Status::newton_failed : status;
        if (known) {
            if (!stiff_) learn_from_step();
            progress.correction = largest_entry(g_);
        }
        if (progress.newton_step || (known && came_nearer(progress))) {
            keep_best();
            continue;
        }
        return_to_best();                                                    // and from there on by a Newton step
        if (max(progress.before, residual_) <= known_to) return evaluate();  // it is not known better
        progress.before = 0, progress.slow = 3;
        progress.correction = std::numeric_limits<Real>::max();
    }
    return_to_best();
    return residual_ <= small && is_noise() ? evaluate() : Status::newton_failed;
}

void Newton::assess(Progress& progress) const {
    const Real& now = progress.correction;
    progress.quiet = max(now, residual_) <= round_off(stagnant);
    const bool gained_little = progress.before > 0 && (progress.quiet ? 2 : 4) * now > progress.before;
    if (gained_little) ++(progress.quiet ? progress.still : progress.slow);  // round-off is not slowness
}

bool Newton::converged(const Progress& progress) const {
    const Real &now = progress.correction, &before = progress.before;
    const Real &size = equations_.size(), &unit = equations_.round_off();
    // Away from a solution a large Jacobian makes corrections small, but not the residual.
    const Real most = min(max(root_of_epsilon, Real(stagnant * newton_.gain() * unit)), Real(1) / 1024);
    if (!(residual_ <= most * size)) return false;
    if (now <= close * epsilon * size) return true;
    if (progress.still > 1 && now <= round_off(stagnant)) return true;
    if (!(2 * now > before) || !(before > 0)) return false;
    // After a fresh Newton step it is the residual's own round-off, of terms as large as the Jacobian makes them.
    const Real noise = unit * max(Real(stagnant), Real(close * newton_.gain()));
    return now <= (progress.newton_step ? noise : Real(64 * epsilon)) * size;
}

/// Broyden's second method can make H singular, and directions learnt near round-off do so little by little.
/// Corrections are then small although the residual is larger than round-off and has not changed by much in the last
/// step.
bool Newton::hides_residual(const Progress& progress) const {
    if (!(progress.before > 0)) return false;
    const Real visible = large_gain * max(progress.correction, round_off(close));
    if (residual_ <= newton_.gain() * visible) return false;
    const Real changed = (r_ - before_).lpNorm<Eigen::Infinity>();
    return residual_ * progress.before > changed * visible;
}

/// It shows in second differences over distances at which the residual is straight.
bool Newton::is_noise() {
    const Real distance = noisy * epsilon * equations_.size();
    p_ = -2 * r_;
    for (const int side : {1, -1}) {
        back_ = x_;
        for (Eigen::Index i = 0; i < back_.size(); ++i) back_[i] += (i % 2 == 0 ? side : -side) * distance;
        if (equations_.residual(back_, u_) != Status::ok) return false;
        p_ += u_;
    }
    H_.apply(p_, u_);
    H_.apply(r_, g_);
    return largest_entry(g_) <= 4 * largest_entry(u_);
}

Status Newton::plan_newton_step(Progress& progress) {
    if (progress.newton_steps++ == 0) H_.clear();  // the known directions have not helped
    progress.slow = 0;
    stiff_ = true;
    const Real distance = sqrt(equations_.round_off()) * max(equations_.size(), residual_);
    if (const Status s = newton_.find(equations_, x_, r_, distance, H_, directions_, g_); s != Status::ok) return s;
    stiff_ = newton_.gain() > large_gain;  // else it was an outlier, and updates go on
    progress.correction = largest_entry(g_);
    return Status::ok;
}

Status Newton::take_step(const Progress& progress) {
    before_.swap(r_);
    x_ -= g_;
    ++iterations_;
    return progress.newton_step && !progress.quiet ? backtrack(progress.before) : evaluate();
}

/// H is still that of where the step began.
Status Newton::backtrack(const Real& before) {
    constexpr int most_halvings = 8;
    back_ = g_;
    Real share = 1;
    for (int i = 0;; ++i) {
        const Status status = evaluate();
        const bool smaller = status == Status::ok && largest_entry(g_) <= (1 - share / 4) * before;
        if (smaller || i == most_halvings) return status;
        share /= 2;
        x_ += share * back_;
    }
}

bool Newton::came_nearer(const Progress& progress) const {
    return progress.correction < 4 * progress.before && (progress.quiet || residual_ < 16 * progress.residual_before);
}

void Newton::keep_best() { best_x_ = x_, best_r_ = r_, best_size_ = equations_.size(); }

void Newton::return_to_best() {
    x_ = best_x_, r_ = best_r_, residual_ = largest_entry(r_);
    equations_.return_to_size(best_size_);
}

Status Newton::evaluate() {
    const Status status = equations_.residual(x_, r_);
    residual_ = equations_.largest();
    if (status == Status::ok) H_.apply(r_, g_);
    return status;
}

void Newton::learn_from_step() {
    p_ = r_ - before_;
    if (largest_entry(p_) <= round_off(noisy)) return;
    Real length = directions_.add(p_, 8, keep());
    if (!(length > 0)) {
        p_ = r_ - before_;
        length = p_.norm();
        p_ /= length;
    }
    u_ = -g_ / length;
    g_ += p_.dot(r_) * u_;
    H_.add(u_, p_, keep());
}

/// Directions of a few steps suffice, except for a stiff system.
Eigen::Index Newton::keep() const {
    return stiff_ || H_.keeps_all() ? directions_.most() : min(few_directions, directions_.most());
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
