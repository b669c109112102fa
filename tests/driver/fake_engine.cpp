// SPDX-License-Identifier: BSD-3-Clause
#include "tests/driver/fake_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>

namespace kreisel {

namespace {

Number number(double value) { return {value, fmt::format("{}", value)}; }

double mass_of(const ParameterValues& parameters) {
    const auto mass = parameters.find("mass");
    return mass == parameters.end() ? 1 : std::get<double>(mass->second);
}

ReportedState state_at(double t, double mass) {
    ReportedState state;
    state.t = number(t);
    ReportedBody body;
    body.name = "top";
    for (std::size_t i = 0; i < 3; ++i) {
        body.x[i] = number(std::sin(t + static_cast<double>(i)) / mass);
        body.v[i] = number(std::cos(t + static_cast<double>(i)));
        body.omega[i] = number(-0.0);
        body.R[4 * i] = number(1);
    }
    state.bodies = {body};
    state.multipliers = {number(1.0 / 3), number(-1e-30), number(1e30)};
    return state;
}

std::vector<OptionDescription> lift_options() {
    return {{"coordinates", "chart of the group", std::string("exp"), {"exp", "cayley"}},
            {"dexpinv", "brackets kept", std::string("exact"), {"exact", "seed"}, 0, 20}};
}

void sleep_milliseconds(long count) { std::this_thread::sleep_for(std::chrono::milliseconds(count)); }

// Simulates the steps, `pause` milliseconds each, and samples; tells how many; false if asked to stop.
bool work(const Cell& cell, long pause, const Watch& watch, SampleSink* samples) {
    const long steps = cell.tolerance > 0 ? std::max(1L, cell.samples) : cell.steps;
    const long stride = cell.samples > 0 && samples != nullptr ? steps / cell.samples : 0;
    if (stride > 0) { samples->begin({{"t", "s"}, {"x1", "m"}}); }
    for (long i = 0; i <= steps; ++i) {
        if (pause > 0 && i > 0) { sleep_milliseconds(pause); }
        if (pause > 0 && watch.stop_requested()) { return false; }
        if (pause > 0) { watch.tell(static_cast<double>(i) / static_cast<double>(steps)); }
        const double t = cell.t_end * static_cast<double>(i) / static_cast<double>(steps);
        if (stride > 0 && i % stride == 0) { samples->add(fmt::format("{},{}", t, std::sin(t))); }
    }
    return true;
}

// Sleeps for a number of milliseconds and tells how many; false if asked to stop.
bool sleep_unless(long milliseconds, const Watch& watch) {
    for (long i = 0; i < milliseconds && !watch.stop_requested(); ++i) {
        watch.tell(static_cast<double>(i) / static_cast<double>(milliseconds));
        sleep_milliseconds(1);
    }
    return !watch.stop_requested();
}

std::vector<ParameterDescription> mechanism() {
    return {{"bodies", ParameterKind::bodies, "", "the bodies", std::vector<BodyData>(), true},
            {"joints", ParameterKind::joints, "", "the joints", std::vector<JointData>()},
            {"forces", ParameterKind::forces, "", "the forces", std::vector<ForceData>{}},
            {"project_initial", ParameterKind::flag, "", "whether to move the start", false}};
}

Outcome misbehave(const Cell& cell, Outcome outcome) {
    if (cell.method == "fake/throws") { throw std::runtime_error("this method always throws"); }
    if (cell.method == "fake/throws_int") { throw 7; }
    if (cell.method == "fake/nan") {
        outcome.status = "non_finite";
        outcome.detail = "omega is not finite at step 5";
        outcome.steps_done = 5;
        outcome.t_reached = cell.t_end / 2;
        outcome.final.reset();
    }
    if (cell.method == "fake/infinite") {
        outcome.metrics.emplace_back("invariant.energy.final", Number{std::numeric_limits<double>::infinity(), "inf"});
    }
    return outcome;
}

}  // namespace

std::vector<ProblemDescription> FakeEngine::problems() const {
    const ParameterDescription mass{"mass", ParameterKind::positive, "kg", "mass", 15.0};
    const ParameterDescription inertia{"inertia", ParameterKind::inertia, "kg m^2", "about the mass centre", identity3};
    const ParameterDescription lever{"lever", ParameterKind::vector, "m", "pivot to mass centre", Vector3{0, 1, 0}};
    const ParameterDescription rotation{"R", ParameterKind::rotation, "1", "initial attitude", identity3};
    const ParameterDescription amplitude{"gravity_amplitude", ParameterKind::scalar, "1", "modulation", 0.5};
    const ParameterDescription bodies{"bodies", ParameterKind::bodies, "", "the links",
                                      std::vector<BodyData>{{.name = "upper"}, {.name = "lower"}}};
    return {{"heavy_top", "a top on a pivot", {"source2000"}, {mass, inertia, lever, rotation, amplitude}, false},
            {"free_top", "a free body", {}, {mass, inertia}, true},
            {"double_pendulum", "two links", {}, {bodies}, false},
            {"multibody",
             "any mechanism",
             {},
             mechanism(),
             false,
             {{"bodies", std::vector<BodyData>{{.name = "rod"}}}},
             "experiments/mechanisms/one_rod.json"}};
}

std::vector<MethodDescription> FakeEngine::methods() const {
    MethodDescription relaxed{"fake/relaxed", Order(2, 2, 1), {}, "a real option"};
    relaxed.options = {{.name = "rho", .summary = "damping", .standard = 0.5, .real_min = 0, .real_max = 1}};
    MethodDescription rk4{"rkmk/rk4", 4, {"kutta1901"}, "classical", 4};
    rk4.options = lift_options();
    MethodDescription midpoint{"rkmk/midpoint", 2, {}, "explicit midpoint", 2};
    midpoint.preserves = {{Property::symmetric, Domain::potential}};  // it is not, but some method of a test must be
    midpoint.options = lift_options();
    MethodDescription quaternion{"baseline/rk4_quaternion", 4, {}, "quaternions", 4};
    quaternion.options = {{"renormalise", "after each step", true}};
    MethodDescription tableau{"fake/tableau", 1, {}, "options that are texts"};
    tableau.options = {{.name = "a", .summary = "rows", .standard = "", .text = OptionText::rows},
                       {.name = "b", .summary = "weights", .standard = "1", .text = OptionText::numbers},
                       {.name = "label", .summary = "of the tableau", .standard = "", .text = OptionText::label},
                       {.name = "order", .summary = "of the tableau", .standard = 1L, .count_min = 1, .count_max = 10}};
    return {rk4,
            midpoint,
            quaternion,
            relaxed,
            tableau,
            {"fake/nan", 1, {}},
            {"fake/infinite", 1, {}},
            {"fake/slow", 1, {}},
            {"fake/deaf", 1, {}},
            {"fake/throws", 1, {}},
            {"fake/throws_int", 1, {}},
            {.name = "fake/pair", .order = 4, .summary = "a pair", .stages = 6, .estimate = 4},
            {.name = "fake/own", .order = 4, .summary = "a control of its own", .own_control = true}};
}

std::vector<ProjectionDescription> FakeEngine::projections() const {
    return {{"none", "no projection", {}},
            {"position_velocity", "both", {}},
            {"terze", "joint", {}, {{"weight", "of the norm", std::string("identity"), {"identity", "mass"}}}}};
}

std::vector<FormulationDescription> FakeEngine::formulations() const {
    return {{"SO3xR3", "direct product"}, {"SE3", "semidirect product"}, {"SO3", "fixed pivot"}};
}

std::vector<MetricDescription> FakeEngine::metrics() const { return engine_binary64().metrics(); }

SystemSummary FakeEngine::summary(const std::string& problem, const ParameterValues& parameters,
                                  const std::string& formulation) const {
    if (const auto inertia = parameters.find("inertia"); inertia != parameters.end()) {
        const auto& matrix = std::get<Matrix3>(inertia->second);
        if (matrix[0] + matrix[4] < matrix[8]) {
            throw ParameterError("/inertia", "expected moments of inertia that a body can have (triangle inequality)");
        }
    }
    if (const auto bodies = parameters.find("bodies");
        problem == "double_pendulum" && std::get<std::vector<BodyData>>(bodies->second).size() != 2) {
        throw ParameterError("/bodies", "expected two bodies");
    }
    SystemSummary summary;
    summary.bodies = problem == "double_pendulum" ? 2 : 1;
    summary.velocities = 6 * summary.bodies;
    summary.constraints = {3 * summary.bodies, 3 * summary.bodies, {}, {}, {}};
    summary.integrals = {{"energy", "J", "forces have a potential"}};
    if (formulation == "SO3" && problem == "double_pendulum") {
        summary.skip_reason = "no body rotates about a fixed point";
    }
    if (mass_of(parameters) > 1000) { summary.warnings = {"a very heavy top"}; }
    return summary;
}

Geometry FakeEngine::geometry(const std::string& /*problem*/, const ParameterValues& parameters) const {
    const LinkGeometry pin{"pin", "spherical", {"ground", "top"}, {Vector3{0, 0, 0}, Vector3{0, -1, 0}}};
    return {{{"top", mass_of(parameters), {0.2, 0, 0, 0, 0.1, 0, 0, 0, 0.2}}}, {pin}};
}

MethodDescription FakeEngine::method(const std::string& name, const OptionValues& options) const {
    const auto all = methods();
    auto described = *std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
    if (name == "fake/tableau") { described.order = static_cast<int>(std::get<long>(options.at("order"))); }
    return described;
}

std::string FakeEngine::skip_reason(const Cell& cell) const {
    if (cell.method.starts_with("baseline/") && cell.formulation == "SE3") {
        return "baselines own their coordinates: SO3 and SO3xR3 only";
    }
    const auto coordinates = cell.options.find("coordinates");
    if (coordinates != cell.options.end() && coordinates->second == OptionValue("cayley") &&
        cell.options.at("dexpinv") != OptionValue("exact")) {
        throw OptionError("dexpinv", "expected no dexpinv under cayley");
    }
    return "";
}

Outcome FakeEngine::run(const Cell& cell, const Reference* reference, const Watch& watch, SampleSink* samples) const {
    ++runs;
    Outcome outcome;
    outcome.cost.cpu_s = 1e-3 * static_cast<double>(runs);  // differs from run to run, as times do
    const long steps = cell.tolerance > 0 ? std::lround(10 * std::pow(cell.tolerance, -0.25)) : cell.steps;
    outcome.cost.evaluations = 4 * steps;
    outcome.cost.exponentials = 3 * steps;
    outcome.cost.brackets = steps;
    outcome.cost.accepted = steps;
    outcome.cost.rejected = cell.tolerance > 0 ? steps / 8 : 0;
    if (cell.repeated) {
        outcome.cost.run_s = 1e-6 * static_cast<double>(steps) * (1 + 0.01 * static_cast<double>(runs));
    }
    if (!work(cell, cell.method == "fake/slow" ? 1 : 0, watch, cell.timed ? nullptr : samples)) {
        outcome.status = "interrupted";
        return outcome;
    }
    if (cell.method == "fake/deaf") { sleep_milliseconds(cell.steps); }
    outcome.steps_done = steps;
    outcome.t_reached = cell.t_end;
    outcome.bodies = 1;
    if (cell.timed) {
        outcome.cost.step_s = 1e-6 * (1 + 0.01 * static_cast<double>(runs));
        outcome.cost.memory = 1000;
        return misbehave(cell, outcome);
    }
    outcome.final = state_at(cell.t_end, mass_of(cell.parameters));
    const double error = cell.tolerance > 0 ? cell.tolerance : std::pow(static_cast<double>(steps), -4);
    if (reference != nullptr &&
        (cell.t_end <= reference->horizon || error > 100 * reference->error.at("error.position").value)) {
        outcome.metrics.emplace_back("error.position", number(error));
        if (!reference->samples.empty()) { outcome.metrics.emplace_back("error.position.max", number(2 * error)); }
    }
    outcome.metrics.emplace_back("invariant.energy", number(1.0 / static_cast<double>(steps)));
    return misbehave(cell, outcome);
}

std::optional<double> FakeEngine::run_time(const Cell& cell, const Watch&) const {
    timed.push_back(cell.steps);
    return 1e-7 * static_cast<double>(cell.steps + static_cast<long>(timed.size()));
}

Reference FakeEngine::reference(const std::string& problem, const ParameterValues& parameters, const BeginState*,
                                double t_end, long samples, const Watch& watch) const {
    ++references;
    if (t_end > 1000 && !sleep_unless(std::lround(t_end), watch)) {
        return {.state = {}, .error = {}, .interrupted = true};
    }
    if (problem == "double_pendulum" && t_end > 100) { throw std::runtime_error("the two step sizes do not agree"); }
    const double uncertainty = t_end > 50 ? 1e-4 : 1e-20;  // chaos past the horizon
    Reference reference{state_at(t_end, mass_of(parameters)), {{"error.position", number(uncertainty)}}, 50, "fake"};
    for (long k = 1; k <= samples; ++k) {
        const double t = t_end * static_cast<double>(k) / static_cast<double>(samples);
        reference.samples.push_back({state_at(t, mass_of(parameters)), {{"error.position", number(uncertainty)}}});
    }
    if (samples > 0) { reference.error["error.position.max"] = number(uncertainty); }
    return reference;
}

ReferenceCheck FakeEngine::check_reference(const std::string&, const ParameterValues& parameters, const BeginState*,
                                           const Reference& reference) const {
    if (reference.state.t.value > reference.horizon) { return {{}, "it lies past its horizon"}; }
    const auto difference = [&](const ReportedState& state) -> std::map<std::string, Number> {
        const double x = state_at(state.t.value, mass_of(parameters)).bodies[0].x[0].value;
        return {{"error.position", number(std::abs(x - state.bodies[0].x[0].value))}};
    };
    ReferenceCheck check{difference(reference.state), ""};
    for (const ReferenceSample& sample : reference.samples) { check.samples.push_back(difference(sample.state)); }
    return check;
}

RotationStability FakeEngine::stability(const std::string& method) const {
    if (method == "fake/own") return {.refusal = "it chooses its steps itself"};
    return {.refusal = "", .limit = 2.8284271, .bounded = true, .growth = -0.000104};
}

Linearisation FakeEngine::linearise(const std::string& problem, const ParameterValues& parameters,
                                    const std::string& formulation, const BeginState* begin) const {
    Linearisation result;
    result.skip_reason = summary(problem, parameters, formulation).skip_reason;
    if (mass_of(parameters) > 1000) { result.refusal = "it is neither an equilibrium nor a steady motion"; }
    result.motion = {{"spin of top about (0, 0, 1)", begin ? begin->t : number(2), "rad/s"}};
    result.rate = number(2);
    result.residual = number(1e-30);
    result.dimension = 6;
    result.eigenvalues = {{number(0), number(1), 2}, {number(1e-31), number(-1), 2}};
    result.of_symmetries = {{number(0), number(0), 2}};
    result.uncertainty = 1e-25;
    return result;
}

}  // namespace kreisel
