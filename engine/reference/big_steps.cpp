// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/big_steps.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// Largest local error that a big step may have, relative to the size of each quantity. The estimate is that of the
/// next lower order, so the true one is far smaller; less would be round-off, which extrapolation amplifies.
Real tolerance() { return 65536 * epsilon; }

/// Parts of w that are each measured relative to their own size: x, quaternion, v, omega of all bodies.
struct Part {
    int begin, end;
};
constexpr std::array<Part, 4> parts = {{{0, 3}, {3, 7}, {7, 10}, {10, 13}}};

void enlarge(PartSizes& sizes, const PartSizes& others) {
    for (std::size_t p = 0; p < sizes.size(); ++p) sizes[p] = max(sizes[p], others[p]);
}

}  // namespace

PartSizes part_sizes(const Real* w, int bodies) {
    PartSizes sizes{};
    for (std::size_t p = 0; p < parts.size(); ++p) {
        Real sum = 0;
        for (int at = 0; at < bodies * QuaternionForm::body_size; at += QuaternionForm::body_size)
            for (int i = parts[p].begin; i < parts[p].end; ++i) sum += w[at + i] * w[at + i];
        sizes[p] = sqrt(sum);
    }
    return sizes;
}

Real largest_ratio(const PartSizes& a, const PartSizes& b) {
    Real ratio = 0;
    for (std::size_t p = 0; p < a.size(); ++p)
        if (a[p] > 0) ratio = max(ratio, Real(a[p] / b[p]));
    return ratio;
}

BigStepRun BigSteps::begin(const Real& H) {
    BigStepRun run{{t_begin_}, {form.start()}};
    const Real* w = run.states[0].data();
    run.sizes = part_sizes(w, form.bodies());
    const auto scale = form.acceleration_scale(t_begin_, w);
    const Real step = abs(H) / 1024;
    enlarge(run.sizes, {scale.linear * step * step, 0, scale.linear * step, scale.angular * step});
    return run;
}

bool BigSteps::append(BigStepRun& run, const Real& t, const Real& allowed) {
    std::vector<Real> w = run.states.back();
    run.status = gbs_.step(run.times.back(), t - run.times.back(), w.data());
    if (run.status != Status::ok) return false;
    PartSizes sizes = run.sizes;
    enlarge(sizes, part_sizes(w.data(), form.bodies()));
    local_error_ = largest_ratio(part_sizes(gbs_.difference().data(), form.bodies()), sizes);
    if (!(local_error_ <= allowed)) return false;
    run.sizes = sizes;
    form.settle(w.data());
    run.times.push_back(t);
    run.states.push_back(std::move(w));
    return true;
}

/// The local error is that of H^{2k-1}. Steps shrink no further than to 2^-40 of the whole: a failure there is a
/// singularity, and an inaccurate step is accepted; the halved run gives the error.
BigStepRun BigSteps::adaptive(const Real& t_end, Real H, const Watch& watch) {
    using std::pow;
    BigStepRun run = begin(H);
    const Real smallest = abs(t_end - t_begin_) / 1099511627776;
    const Real infinity = std::numeric_limits<Real>::infinity();
    while (run.times.back() != t_end) {
        if ((run.interrupted = watch.stop_requested())) return run;
        const Real t = run.times.back(), left = t_end - t;
        watch.tell(1 - to_double(left / (t_end - t_begin_)));
        const bool last = abs(H) >= abs(left), minimal = abs(H) <= smallest;
        const bool done = append(run, last ? t_end : Real(t + H), minimal ? infinity : tolerance());
        if (run.status != Status::ok) {
            if (minimal) return run;
            H = (last ? left : H) / 4;
            continue;
        }
        const Real ratio = max(Real(4 * local_error_ / tolerance()), Real(epsilon));
        const Real factor = pow(ratio, -Real(1) / (2 * reference_columns - 1));
        if (!done || !last) H = (last ? left : H) * min(max(factor, Real(1) / 4), Real(2));
    }
    return run;
}

BigStepRun BigSteps::halved(const BigStepRun& coarse, const Watch& watch) {
    BigStepRun run = begin(0);
    enlarge(run.sizes, coarse.sizes);
    for (std::size_t n = 1; n < coarse.times.size(); ++n) {
        if ((run.interrupted = watch.stop_requested())) return run;
        watch.tell(static_cast<double>(n - 1) / static_cast<double>(coarse.times.size() - 1));
        const Real middle = (coarse.times[n - 1] + coarse.times[n]) / 2;
        for (const Real& t : {middle, coarse.times[n]})
            if (!append(run, t, std::numeric_limits<Real>::infinity())) return run;
    }
    return run;
}

Status BigSteps::state_at(const BigStepRun& run, const Real& t, std::vector<Real>& w) {
    const auto after = std::find_if(run.times.begin(), run.times.end(), [&](const Real& x) { return abs(x) > abs(t); });
    const auto n = static_cast<std::size_t>(after - run.times.begin()) - 1;
    w = run.states[n];
    if (run.times[n] == t) return Status::ok;
    const Status status = gbs_.step(run.times[n], t - run.times[n], w.data());
    if (status == Status::ok) form.settle(w.data());
    return status;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
