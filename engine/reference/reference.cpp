// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/reference.hpp"

#include <stdexcept>
#include <utility>

#include "engine/reference/big_steps.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// A big step of about two radians, at the fastest body's initial rate, of a motion that lasts so long.
Real first_step(const Model& model, const Real& duration) {
    Real rate = 0;
    for (const Body& body : model.bodies) rate = max(rate, Real(body.start.omega.norm()));
    return duration / max(Real(1), Real(rate * abs(duration) / 2));
}

/// The share of the work that the coarse run takes, before its number of steps is known: big steps meet their tolerance
/// where they are some four times shorter than the first one. The fine run has twice as many, a sample takes two.
double coarse_share(double first_steps, long samples) {
    const double steps = 4 * first_steps;
    return steps / (3 * steps + 2 * static_cast<double>(samples));
}

/// What the fine run takes of the rest.
double fine_share(std::size_t steps, long samples) {
    const auto fine = static_cast<double>(steps), sampling = static_cast<double>(samples);
    return fine > 0 ? fine / (fine + sampling) : 0;
}

/// Last big step up to which two runs agree.
std::size_t agreed_steps(const BigStepRun& coarse, const BigStepRun& fine, int bodies) {
    const Real limit = Real(1) / 1000000000000;
    std::vector<Real> difference(static_cast<std::size_t>(bodies * QuaternionForm::body_size));
    std::size_t n = 1;
    for (; n < coarse.states.size() && 2 * n < fine.states.size(); ++n) {
        for (std::size_t i = 0; i < difference.size(); ++i) difference[i] = coarse.states[n][i] - fine.states[2 * n][i];
        if (!(largest_ratio(part_sizes(difference.data(), bodies), fine.sizes) <= limit)) break;
    }
    return n - 1;
}

/// The state of the fine run at a time, with its difference from that of the coarse one.
struct ComparedState {
    SampledPoint sample;
    std::vector<SpringAngle> angles;
    Status status = Status::ok;
};

ComparedState compared(QuaternionForm& form, const Real& t, const Real* coarse, const Real* fine) {
    ComparedState out;
    ReferencePoint& point = out.sample.point;
    point = {t, form.states(fine)};
    out.angles = form.angles(fine);
    out.sample.error = distance(point.states, form.states(coarse));
    const auto drift = form.residual(t, fine);
    out.sample.error.position = max(out.sample.error.position, drift.position);
    out.sample.error.velocity = max(out.sample.error.velocity, drift.velocity);
    if (form.has_redundant_rows()) return out;
    std::vector<Real> lambda;
    for (const Status s : {form.multipliers(t, coarse, lambda), form.multipliers(t, fine, out.sample.multipliers)})
        if (s != Status::ok) out.status = s;
    if (out.status == Status::ok)
        out.sample.multiplier_error = multiplier_distance(form.rows(), lambda, out.sample.multipliers);
    return out;
}

void compare_ends(QuaternionForm& form, const Real& t_end, const BigStepRun& coarse, const BigStepRun& fine,
                  ReferenceSolution& out) {
    ComparedState end = compared(form, t_end, coarse.states.back().data(), fine.states.back().data());
    out.states = std::move(end.sample.point.states);
    out.angles = std::move(end.angles);
    const Distance& error = end.sample.error;
    out.position_error = error.position, out.rotation_error = error.rotation;
    out.velocity_error = error.velocity, out.omega_error = error.omega;
    out.multipliers = std::move(end.sample.multipliers);
    out.multiplier_error = end.sample.multiplier_error;
    if (end.status != Status::ok) out.stopped = name(end.status);
}

/// At t_end the states of the last big steps themselves.
void take_samples(BigSteps& steps, const BigStepRun& coarse, const BigStepRun& fine, long count, const Real& t_end,
                  const Watch& watch, ReferenceSolution& out) {
    const Real t_begin = coarse.times.front();
    std::vector<Real> a, b;
    for (long k = 1; k <= count; ++k) {
        if ((out.interrupted = watch.stop_requested())) return;
        watch.tell(static_cast<double>(k - 1) / static_cast<double>(count));
        const Real t = k == count ? t_end : Real(t_begin + (t_end - t_begin) / Real(count) * Real(k));
        for (const Status s : {steps.state_at(coarse, t, a), steps.state_at(fine, t, b)})
            if (s != Status::ok) out.stopped = name(s);
        if (!out.stopped.empty()) return;
        ComparedState now = compared(steps.form, t, a.data(), b.data());
        if (now.status != Status::ok) now.sample.multipliers.clear();
        out.samples.push_back(std::move(now.sample));
    }
}

}  // namespace

ReferenceSolution reference_solution(const Model& model, const Real& t_end, const Watch& watch, long samples,
                                     const Real& t_begin) {
    if (!isfinite(t_end)) throw std::invalid_argument("a reference solution needs a finite end time");
    BigSteps integration(model, t_begin);
    const Real H = first_step(model, t_end - t_begin);
    const double coarse_end = coarse_share(to_double((t_end - t_begin) / H), samples);
    const BigStepRun coarse = integration.adaptive(t_end, H, watch.part(0, coarse_end));
    const std::size_t steps = coarse.states.size() - 1;
    const double fine_end = coarse_end + (1 - coarse_end) * fine_share(steps, samples);
    const BigStepRun fine = integration.halved(coarse, watch.part(coarse_end, fine_end));

    ReferenceSolution out;
    out.interrupted = coarse.interrupted || fine.interrupted;
    if (out.interrupted) return out;
    const std::size_t agreed = agreed_steps(coarse, fine, integration.form.bodies());
    out.horizon = coarse.times[agreed];
    for (std::size_t n = 0; n <= agreed && 2 * n < fine.states.size(); ++n)
        out.path.push_back({coarse.times[n], integration.form.states(fine.states[2 * n].data())});
    out.sizes = {fine.sizes[0], fine.sizes[2], fine.sizes[3]};
    out.route = "extrapolation of order " + std::to_string(2 * reference_columns) + " on quaternion coordinates, " +
                std::to_string(steps) + " and " + std::to_string(2 * steps) + " big steps";
    for (const BigStepRun* run : {&coarse, &fine})
        if (run->status != Status::ok) out.stopped = name(run->status);
    if (!out.stopped.empty()) return out;
    compare_ends(integration.form, t_end, coarse, fine, out);
    if (out.stopped.empty()) take_samples(integration, coarse, fine, samples, t_end, watch.part(fine_end, 1), out);
    if (out.interrupted) return {.interrupted = true};
    for (std::size_t n = agreed + 1; n <= steps; ++n) {
        out.beyond.push_back({coarse.times[n], integration.form.states(fine.states[2 * n].data())});
        allow_for(out, distance(integration.form.states(coarse.states[n].data()), out.beyond.back().states));
    }
    watch.tell(1);
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
