// SPDX-License-Identifier: BSD-3-Clause
#include "engine/reported_reference.hpp"

#include <utility>

#include "engine/begin.hpp"
#include "engine/metrics/comparison.hpp"
#include "engine/metrics/metric.hpp"
#include "engine/reference/reference.hpp"
#include "engine/reference/taylor/taylor_route.hpp"
#include "lie/so3.hpp"
#include "mechanics/joints/joint_rows.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

/// A model and the time at which it starts.
struct TimedModel {
    Model model;
    Real t = 0;
};

/// Rotations of a state are orthogonal to the digits that it has; the routes, which hold them in different coordinates,
/// are given the same ones.
TimedModel begun(const Problem& problem, const ParameterValues& values, const BeginState* begin) {
    const Model model = problem.build(Parameters(values));
    if (!begin) return {model};
    Model moved = moved_to(model, *begin);
    for (Body& body : moved.bodies) body.start.R = SO3::exp(SO3::log(body.start.R));
    return {moved, from_number(begin->t)};
}

void allow_for_closed_form(const Problem& problem, const ParameterValues& values, const Real& t_end,
                           ReferenceSolution& solution) {
    const auto exact = [&](const Real& t) { return problem.closed_form(Parameters(values), t); };
    allow_for(solution, distance(solution.states, exact(t_end)));
    for (SampledPoint& sample : solution.samples)
        sample.error = largest(sample.error, distance(sample.point.states, exact(sample.point.t)));
    solution.route += "; closed form";
}

std::map<std::string, Number> error_at_end(const ReferenceSolution& solution, const Real& t_end,
                                           const std::vector<ConstraintRow>& rows) {
    if (!solution.compared) return {};
    // Past the horizon, the multipliers' difference at the end by itself means nothing.
    const bool agreed = !solution.multipliers.empty() && abs(solution.horizon) >= abs(t_end);
    return errors_of({{solution.position_error, solution.rotation_error, solution.velocity_error, solution.omega_error},
                      agreed ? solution.multiplier_error : Separation::unknown_multipliers()},
                     rows);
}

/// Of each metric that every sample has.
void add_largest(const std::vector<ReferenceSample>& samples, std::map<std::string, Number>& error) {
    for (const Metric& metric : metrics()) {
        const std::string& name = metric.description.name;
        Number worst;
        std::size_t known = 0;
        for (const ReferenceSample& sample : samples) {
            const auto found = sample.error.find(name);
            if (found == sample.error.end()) break;
            if (known++ == 0 || found->second.value > worst.value) worst = found->second;
        }
        if (known > 0 && known == samples.size()) error[name + largest_of_error] = worst;
    }
}

std::vector<Real> from_numbers(const std::vector<Number>& numbers) {
    std::vector<Real> values;
    for (const Number& x : numbers) values.push_back(from_number(x));
    return values;
}

/// How far the second route is from a stored state of its time; `lambda`: its multipliers there.
std::map<std::string, Number> difference_from(const ReportedState& state, const TaylorRoute& route,
                                              const std::vector<Real>& lambda, const std::vector<ConstraintRow>& rows) {
    Separation apart{distance(route.states(), from_report(state))};
    const std::vector<Real> exact = from_numbers(state.multipliers);
    if (exact.size() == rows.size() && lambda.size() == rows.size())
        apart.multipliers = multiplier_distance(rows, lambda, exact);
    return errors_of(apart, rows);
}

}  // namespace

Reference reported_reference(const Problem& problem, const ParameterValues& values, const BeginState* begin,
                             double t_end, long samples, const Watch& watch) {
    const auto [model, t_begin] = begun(problem, values, begin);
    const auto rows = constraint_rows(model);
    ReferenceSolution solution = confirmed_reference(model, decimal(t_end), watch, samples, t_begin);
    if (solution.interrupted) return {.state = {}, .error = {}, .interrupted = true};
    if (!solution.stopped.empty())
        return {.state = {}, .error = {}, .horizon = 0, .route = solution.route + ", stopped: " + solution.stopped};
    if (problem.closed_form && !begin) allow_for_closed_form(problem, values, decimal(t_end), solution);
    Reference reference;
    reference.state = to_report(decimal(t_end), solution.states, model, solution.multipliers, solution.angles);
    reference.error = error_at_end(solution, decimal(t_end), rows);
    for (const SampledPoint& sample : solution.samples)
        reference.samples.push_back({to_report(sample.point.t, sample.point.states, model, sample.multipliers, {}),
                                     errors_of({sample.error, sample.multiplier_error}, rows)});
    add_largest(reference.samples, reference.error);
    reference.horizon = to_double(solution.horizon);
    reference.route = solution.route;
    return reference;
}

ReferenceCheck checked_reference(const Problem& problem, const ParameterValues& values, const BeginState* begin,
                                 const Reference& reference) {
    if (reference.state.bodies.empty()) return {.difference = {}, .failure = "it has no state: " + reference.route};
    if (reference.state.t.value > reference.horizon) return {.difference = {}, .failure = "it lies past its horizon"};
    const auto [model, t_begin] = begun(problem, values, begin);
    const auto rows = constraint_rows(model);
    TaylorRoute route(model, t_begin);
    ReferenceCheck check;
    Status status = Status::ok;
    for (const ReferenceSample& sample : reference.samples) {
        if ((status = route.advance(from_number(sample.state.t), {})) != Status::ok) break;
        check.samples.push_back(difference_from(sample.state, route, route.multipliers(), rows));
    }
    std::vector<Real> lambda;
    if (status == Status::ok) status = route.advance(from_number(reference.state.t), {});
    if (status == Status::ok) status = route.multipliers(lambda);
    if (status != Status::ok) return {.difference = {}, .failure = std::string("Taylor series: ") + name(status)};
    check.difference = difference_from(reference.state, route, lambda, rows);
    return check;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
