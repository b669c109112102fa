// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/reference.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <utility>

#include "engine/reference/gbs.hpp"
#include "engine/reference/quaternion_form.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

#if KREISEL_QUAD
constexpr int columns = 11;
#else
constexpr int columns = 8;
#endif

/// Largest local error that a big step may have, relative to the size of each quantity. The estimate is that of the
/// next lower order, so the true one is far smaller; less would be round-off, which extrapolation amplifies.
Real tolerance() { return 65536 * epsilon; }

/// Parts of w that are each measured relative to their own size: x, quaternion, v, omega of all bodies.
struct Part {
    int begin, end;
};
constexpr std::array<Part, 4> parts = {{{0, 3}, {3, 7}, {7, 10}, {10, 13}}};
using Sizes = std::array<Real, 4>;

/// Norm of each part over all bodies.
Sizes norms(const Real* w, int bodies) {
    Sizes sizes{};
    for (std::size_t p = 0; p < parts.size(); ++p) {
        Real sum = 0;
        for (int at = 0; at < bodies * QuaternionForm::body_size; at += QuaternionForm::body_size)
            for (int i = parts[p].begin; i < parts[p].end; ++i) sum += w[at + i] * w[at + i];
        sizes[p] = sqrt(sum);
    }
    return sizes;
}

/// Largest a_p / b_p; a part that is always zero is ignored.
Real largest_ratio(const Sizes& a, const Sizes& b) {
    Real ratio = 0;
    for (std::size_t p = 0; p < a.size(); ++p)
        if (a[p] > 0) ratio = max(ratio, Real(a[p] / b[p]));
    return ratio;
}

void enlarge(Sizes& sizes, const Sizes& others) {
    for (std::size_t p = 0; p < sizes.size(); ++p) sizes[p] = max(sizes[p], others[p]);
}

/// One run: times and states of its big steps, the start included, up to where it stopped.
struct Trajectory {
    std::vector<Real> times;
    std::vector<std::vector<Real>> states;
    Sizes sizes{};  ///< largest of all steps
    Status status = Status::ok;
    bool interrupted = false;
};

/// Integrates one model; not copied, since the extrapolation refers to its form.
class Integration {
  public:
    explicit Integration(const Model& model)
        : form(model), gbs_(even_sequence(columns), form.dimension(), [this](const Real& t, const Real* w, Real* rate) {
              return form.rate(t, w, rate);
          }) {}
    Integration(const Integration&) = delete;
    Integration& operator=(const Integration&) = delete;

    /// Big steps as large as the tolerance allows, from the guess H.
    Trajectory adaptive(const Real& t_end, Real H, const std::stop_token& stop);
    /// Every big step of another run in two halves.
    Trajectory halved(const Trajectory& coarse, const std::stop_token& stop);

    QuaternionForm form;

  private:
    /// H is a guess of the big steps.
    Trajectory begin(const Real& H);
    /// Appends the step to time t. On failure, or if its local error exceeds `allowed`, the run is as before.
    bool append(Trajectory& run, const Real& t, const Real& allowed);

    Extrapolation gbs_;
    Real local_error_ = 0;  // of the last step, relative to the sizes
};

Trajectory Integration::begin(const Real& H) {
    Trajectory run{{Real(0)}, {form.start()}};
    const Real* w = run.states[0].data();
    run.sizes = norms(w, form.bodies());
    const auto scale = form.acceleration_scale(0, w);
    const Real step = abs(H) / 1024;
    enlarge(run.sizes, {scale.linear * step * step, 0, scale.linear * step, scale.angular * step});
    return run;
}

bool Integration::append(Trajectory& run, const Real& t, const Real& allowed) {
    std::vector<Real> w = run.states.back();
    run.status = gbs_.step(run.times.back(), t - run.times.back(), w.data());
    if (run.status != Status::ok) return false;
    Sizes sizes = run.sizes;
    enlarge(sizes, norms(w.data(), form.bodies()));
    local_error_ = largest_ratio(norms(gbs_.difference().data(), form.bodies()), sizes);
    if (!(local_error_ <= allowed)) return false;
    run.sizes = sizes;
    form.settle(w.data());
    run.times.push_back(t);
    run.states.push_back(std::move(w));
    return true;
}

/// The local error is that of H^{2k-1}. Steps shrink no further than to 2^-40 of the whole: a failure there is a
/// singularity, and an inaccurate step is accepted; the halved run gives the error.
Trajectory Integration::adaptive(const Real& t_end, Real H, const std::stop_token& stop) {
    using std::pow;
    Trajectory run = begin(H);
    const Real smallest = abs(t_end) / 1099511627776;
    const Real infinity = std::numeric_limits<Real>::infinity();
    while (run.times.back() != t_end) {
        if ((run.interrupted = stop.stop_requested())) return run;
        const Real t = run.times.back(), left = t_end - t;
        const bool last = abs(H) >= abs(left), minimal = abs(H) <= smallest;
        const bool done = append(run, last ? t_end : Real(t + H), minimal ? infinity : tolerance());
        if (run.status != Status::ok) {
            if (minimal) return run;
            H = (last ? left : H) / 4;
            continue;
        }
        const Real ratio = max(Real(4 * local_error_ / tolerance()), Real(epsilon));
        const Real factor = pow(ratio, -Real(1) / (2 * columns - 1));
        if (!done || !last) H = (last ? left : H) * min(max(factor, Real(1) / 4), Real(2));
    }
    return run;
}

Trajectory Integration::halved(const Trajectory& coarse, const std::stop_token& stop) {
    Trajectory run = begin(0);
    enlarge(run.sizes, coarse.sizes);
    for (std::size_t n = 1; n < coarse.times.size(); ++n) {
        if ((run.interrupted = stop.stop_requested())) return run;
        const Real middle = (coarse.times[n - 1] + coarse.times[n]) / 2;
        for (const Real& t : {middle, coarse.times[n]})
            if (!append(run, t, std::numeric_limits<Real>::infinity())) return run;
    }
    return run;
}

/// A big step of about two radians, at the fastest body's initial rate.
Real first_step(const Model& model, const Real& t_end) {
    Real rate = 0;
    for (const Body& body : model.bodies) rate = max(rate, Real(body.start.omega.norm()));
    return t_end / max(Real(1), Real(rate * abs(t_end) / 2));
}

/// Last big step up to which two runs agree.
std::size_t agreed_steps(const Trajectory& coarse, const Trajectory& fine, int bodies) {
    const Real limit = Real(1) / 1000000000000;
    std::vector<Real> difference(static_cast<std::size_t>(bodies * QuaternionForm::body_size));
    std::size_t n = 1;
    for (; n < coarse.states.size() && 2 * n < fine.states.size(); ++n) {
        for (std::size_t i = 0; i < difference.size(); ++i) difference[i] = coarse.states[n][i] - fine.states[2 * n][i];
        if (!(largest_ratio(norms(difference.data(), bodies), fine.sizes) <= limit)) break;
    }
    return n - 1;
}

/// The end state of the fine run, with its differences from the coarse one.
void compare_ends(QuaternionForm& form, const Real& t_end, const Trajectory& coarse, const Trajectory& fine,
                  ReferenceSolution& out) {
    const Real *a = coarse.states.back().data(), *b = fine.states.back().data();
    out.states = form.states(b);
    out.angles = form.angles(b);
    const Distance apart = distance(out.states, form.states(a));
    const auto drift = form.residual(t_end, b);
    out.position_error = max(apart.position, drift.position), out.rotation_error = apart.rotation;
    out.velocity_error = max(apart.velocity, drift.velocity), out.omega_error = apart.omega;
    if (form.has_redundant_rows()) return;
    std::vector<Real> lambda;
    for (const Status s : {form.multipliers(t_end, a, lambda), form.multipliers(t_end, b, out.multipliers)})
        if (s != Status::ok) out.stopped = name(s);
    if (out.stopped.empty()) out.multiplier_error = multiplier_distance(form.rows(), lambda, out.multipliers);
}

}  // namespace

ReferenceSolution reference_solution(const Model& model, const Real& t_end, const std::stop_token& stop) {
    if (!isfinite(t_end)) throw std::invalid_argument("a reference solution needs a finite end time");
    Integration integration(model);
    const Trajectory coarse = integration.adaptive(t_end, first_step(model, t_end), stop);
    const Trajectory fine = integration.halved(coarse, stop);

    ReferenceSolution out;
    out.interrupted = coarse.interrupted || fine.interrupted;
    if (out.interrupted) return out;
    const std::size_t steps = coarse.states.size() - 1;
    const std::size_t agreed = agreed_steps(coarse, fine, integration.form.bodies());
    out.horizon = coarse.times[agreed];
    for (std::size_t n = 0; n <= agreed && 2 * n < fine.states.size(); ++n)
        out.path.push_back({coarse.times[n], integration.form.states(fine.states[2 * n].data())});
    out.sizes = {fine.sizes[0], fine.sizes[2], fine.sizes[3]};
    out.route = "extrapolation of order " + std::to_string(2 * columns) + " on quaternion coordinates, " +
                std::to_string(steps) + " and " + std::to_string(2 * steps) + " big steps";
    for (const Trajectory* run : {&coarse, &fine})
        if (run->status != Status::ok) out.stopped = name(run->status);
    if (!out.stopped.empty()) return out;
    compare_ends(integration.form, t_end, coarse, fine, out);
    for (std::size_t n = agreed + 1; n <= steps; ++n) {
        out.beyond.push_back({coarse.times[n], integration.form.states(fine.states[2 * n].data())});
        allow_for(out, distance(integration.form.states(coarse.states[n].data()), out.beyond.back().states));
    }
    return out;
}

void allow_for(ReferenceSolution& reference, const Distance& distance) {
    reference.position_error = max(reference.position_error, distance.position);
    reference.rotation_error = max(reference.rotation_error, distance.rotation);
    reference.velocity_error = max(reference.velocity_error, distance.velocity);
    reference.omega_error = max(reference.omega_error, distance.omega);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
