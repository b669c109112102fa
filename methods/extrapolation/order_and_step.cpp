// SPDX-License-Identifier: BSD-3-Clause
#include "methods/extrapolation/order_and_step.hpp"

#include "methods/extrapolation/neville.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

const Real tenth = Real(1) / 10;

/// H_j / H; what it may change by, at most 50^{1/(2j-1)} up and four times that down, as in the code of [hairer1993].
Real growth(int j, const Real& error) {
    const Real exponent = Real(1) / (2 * j - 1), most = pow(Real(50), exponent);
    const Real wanted = error > 0 ? Real(Real(94) / 100 * pow(Real(65) / 100 / error, exponent)) : most;
    return min(most, max(Real(1 / (4 * most)), wanted));
}

}  // namespace

int OrderAndStep::first_aim(const Real& tolerance, int columns) {
    const Real columns_per_bit = Real(18) / 100;  // 0.6 per decimal digit
    return std::clamp(static_cast<int>(to_double(Real(3) / 2 - columns_per_bit * log2(tolerance))), 2, columns - 1);
}

void OrderAndStep::begin(const Real& H, bool shortened) { H_ = H, shortened_ = shortened; }

Real OrderAndStep::work(int j) { return Real(solves_of_rows(j)) / size(j); }

OrderAndStep::Verdict OrderAndStep::judge(int j, const Real& error) {
    size(j) = abs(H_) * growth(j, error);
    const bool any_line = unknown_ || shortened_;
    if (j < aim_ - 1 && !any_line) return Verdict::next_line;
    if (error <= 1) return Verdict::accept;
    // From line to line the error falls by about (n_1/n_{j+1})^2.
    const Real k = substeps(aim_) / substeps(1), next = substeps(aim_ + 1) / substeps(1);
    if (j == aim_ - 1 && error > k * k * next * next) return Verdict::reject;
    if (j == aim_ && error > next * next) return Verdict::reject;
    return j > aim_ ? Verdict::reject : Verdict::next_line;
}

/// The next k after acceptance in line j. There is no W_1, and nothing to compare W_2 with.
int OrderAndStep::best_after(int j) {
    const Real saved = 1 - tenth;
    if (j == 2) return 3;
    if (j <= aim_) {
        if (work(j - 1) < saved * work(j)) return j - 1;
        return work(j) < saved * work(j - 1) ? j + 1 : j;
    }
    int best = j - 1;
    if (best > 2 && work(best - 1) < saved * work(best)) --best;
    return work(j) < saved * work(best) ? j : best;
}

void OrderAndStep::accepted(int j) {
    int aim = std::min(best_after(j), columns_ - 1);
    if (after_rejection_) aim = std::min(aim, j);
    Real next = aim <= j ? size(aim) : Real(size(j) * solves_of_rows(aim) / solves_of_rows(j));
    if (after_rejection_) next = min(next, Real(abs(H_)));
    unknown_ = after_rejection_ = false;
    // A step cut short at a limit says little of longer ones.
    if (shortened_ && next < abs(step_)) return;
    aim_ = aim, step_ = with_sign(next);
}

void OrderAndStep::rejected(int j) {
    after_rejection_ = true;
    if (j < 2) {
        step_ = H_ / 2;
        return;
    }
    aim_ = std::min(aim_, j);
    if (aim_ > 2 && work(aim_ - 1) < (1 - tenth) * work(aim_)) --aim_;
    step_ = with_sign(min(size(aim_), Real(abs(H_) * (1 - tenth))));
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
