// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reference/taylor/taylor_route.hpp"

#include <limits>

#include "mechanics/joints/joint_rows.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

bool agree(const Distance& d, const MotionSize& sizes) {
    const Real limit = Real(1) / 1000000000000;
    return d.position <= limit * sizes.position && d.rotation <= limit && d.velocity <= limit * sizes.velocity &&
           d.omega <= limit * sizes.omega;
}

/// The share of the work that the first route takes, measured; the second one takes the rest, for samples twice.
double first_share(long samples) { return samples > 0 ? 0.65 : 0.75; }

/// Tells how many of the first route's big steps the second one has reached.
void tell(const Watch& watch, const ReferenceSolution& first, std::size_t reached) {
    watch.tell(static_cast<double>(reached) / static_cast<double>(first.path.size() + first.beyond.size()));
}

/// The last of the first route's big steps up to which the second one agrees, and the distance there.
struct Agreement {
    Real horizon = 0;
    Distance distance;
    Status status = Status::ok;
};

Agreement follow(TaylorRoute& route, const ReferenceSolution& first, const Watch& watch) {
    Agreement agreement;
    std::size_t reached = 0;
    for (const ReferencePoint& point : first.path) {
        tell(watch, first, reached++);
        agreement.status = route.advance(point.t, watch);
        if (agreement.status != Status::ok || route.interrupted()) break;
        const Distance d = distance(route.states(), point.states);
        if (!agree(d, first.sizes)) break;
        agreement.horizon = point.t, agreement.distance = d;
    }
    return agreement;
}

/// The largest distance between the routes from there to the end.
void go_beyond(TaylorRoute& route, const ReferenceSolution& first, const Watch& watch, Agreement& agreement) {
    std::size_t reached = 0;
    const auto meet = [&](const ReferencePoint& point) {
        ++reached;
        if (abs(point.t) <= abs(agreement.horizon) || agreement.status != Status::ok || route.interrupted()) return;
        tell(watch, first, reached - 1);
        agreement.status = route.advance(point.t, watch);
        agreement.distance = largest(agreement.distance, distance(route.states(), point.states));
    };
    for (const ReferencePoint& point : first.path) meet(point);
    for (const ReferencePoint& point : first.beyond) meet(point);
}

/// The multipliers' error of a sample: at least the distance from those of the second route; unknown without these.
MultiplierDistance confirmed(const SampledPoint& sample, const std::vector<Real>& lambda,
                             const std::vector<ConstraintRow>& rows) {
    const Real unknown = std::numeric_limits<Real>::quiet_NaN();
    if (lambda.size() != rows.size() || sample.multipliers.size() != rows.size()) return {unknown, unknown};
    const MultiplierDistance apart = multiplier_distance(rows, lambda, sample.multipliers);
    return {max(sample.multiplier_error.force, apart.force), max(sample.multiplier_error.torque, apart.torque)};
}

/// Follows the samples by a run of its own, so that the one to the end is the same with and without them; false if it
/// was asked to stop.
bool confirm_samples(const Model& model, const Real& t_begin, const Watch& watch, ReferenceSolution& out) {
    TaylorRoute route(model, t_begin);
    const auto rows = constraint_rows(model);
    const Real unknown = std::numeric_limits<Real>::quiet_NaN();
    Status status = Status::ok;
    Distance since;  // the horizon
    for (SampledPoint& sample : out.samples) {
        watch.tell(static_cast<double>(&sample - out.samples.data()) / static_cast<double>(out.samples.size()));
        if (status == Status::ok) status = route.advance(sample.point.t, watch);
        if (route.interrupted()) return false;
        const bool known = status == Status::ok, past = abs(sample.point.t) > abs(out.horizon);
        sample.multiplier_error = confirmed(sample, known && !past ? route.multipliers() : std::vector<Real>(), rows);
        sample.error = known ? largest(sample.error, distance(route.states(), sample.point.states))
                             : Distance{unknown, unknown, unknown, unknown};
        if (past) sample.error = since = largest(since, sample.error);
    }
    return true;
}

}  // namespace

TaylorRoute::TaylorRoute(const Model& model, const Real& t_begin)
    : series_(model, taylor_order), t_(t_begin), base_t_(t_begin) {
    for (const Body& body : model.bodies) states_.push_back(body.start);
}

Status TaylorRoute::expand() {
    if (steps_ > 0) series_.move_on(t_ - base_t_);
    base_t_ = t_;
    ++steps_;
    return series_.expand(t_, states_);
}

Status TaylorRoute::advance(const Real& t, const Watch& watch) {
    const Real smallest = abs(t - t_) / 1099511627776;
    while (t_ != t) {
        if ((interrupted_ = watch.stop_requested())) return Status::ok;
        if (!holds_) {
            if (const Status s = expand(); s != Status::ok) return s;
            reach_ = series_.reach(reach_ == 0 ? Real(t - t_) : Real(4 * reach_));
            if (abs(reach_) <= smallest) return Status::singular_kkt;
        }
        holds_ = abs(t - base_t_) <= abs(reach_);
        t_ = holds_ ? t : Real(base_t_ + reach_);
        states_ = series_.states(t_ - base_t_);
        if (series_.has_parted(t_ - base_t_)) return Status::turn_lost;
    }
    return Status::ok;
}

Status TaylorRoute::multipliers(std::vector<Real>& lambda) {
    holds_ = false;
    const Status status = expand();
    if (status == Status::ok) lambda = series_.multipliers();
    return status;
}

ReferenceSolution confirmed_reference(const Model& model, const Real& t_end, const Watch& watch, long samples,
                                      const Real& t_begin) {
    const double first_end = first_share(samples), second_end = samples > 0 ? (first_end + 1) / 2 : 1;
    ReferenceSolution out = reference_solution(model, t_end, watch.part(0, first_end), samples, t_begin);
    if (out.interrupted || !out.stopped.empty()) return out;
    TaylorRoute route(model, t_begin);
    const Watch along = watch.part(first_end, second_end);
    Agreement agreement = follow(route, out, along);
    if (route.interrupted()) return {.interrupted = true};
    out.horizon = agreement.horizon;
    if (agreement.status == Status::ok && out.horizon != t_end) {  // past the horizon: how far the routes are apart
        go_beyond(route, out, along, agreement);
        if (route.interrupted()) return {.interrupted = true};
    }
    if (!confirm_samples(model, t_begin, watch.part(second_end, 1), out)) return {.interrupted = true};
    watch.tell(1);
    out.route += "; Taylor series of order " + std::to_string(taylor_order) + " in rotation matrices, " +
                 std::to_string(route.steps()) + " steps";
    if (agreement.status != Status::ok) out.route += std::string(", ended by ") + name(agreement.status);
    out.compared = agreement.status == Status::ok && isfinite(agreement.distance.rotation);
    if (!out.compared) return out;
    allow_for(out, agreement.distance);
    std::vector<Real> lambda;
    if (route.multipliers(lambda) != Status::ok || lambda.size() != out.multipliers.size()) return out;
    const MultiplierDistance apart = multiplier_distance(constraint_rows(model), lambda, out.multipliers);
    out.multiplier_error = {max(out.multiplier_error.force, apart.force),
                            max(out.multiplier_error.torque, apart.torque)};
    return out;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
