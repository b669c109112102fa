// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/doctor/self_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

namespace kreisel {

namespace {

constexpr const char *problem_name = "lagrange_top", *method_name = "rkmk/rk4", *metric = "error.position";
constexpr double t_end = 1, tolerated_order = 0.1, certain_to = 1e-20;  // s, -, m
constexpr long coarse = 256;
constexpr const char* advice = "build kreisel again (cmake --build), and run ./check, which names what is wrong";

Cell cell_of(const ProblemDescription& problem, const Engine& engine, long steps) {
    const OptionValues options = with_defaults({}, find_named(engine.methods(), method_name)->options);
    return {.problem = problem.name,
            .parameters = default_parameters(problem),
            .formulation = "SO3xR3",
            .method = method_name,
            .options = options,
            .projection = "none",
            .t_end = t_end,
            .steps = steps,
            .metrics = {metric}};
}

std::optional<double> error_of(const Outcome& outcome) {
    const auto found = std::find_if(outcome.metrics.begin(), outcome.metrics.end(),
                                    [](const auto& entry) { return entry.first == metric; });
    const bool measured = outcome.status == "ok" && found != outcome.metrics.end();
    return measured ? std::optional(found->second.value) : std::nullopt;
}

Finding reference_finding(const Reference& reference) {
    const auto error = reference.error.find(metric);
    const bool good = error != reference.error.end() && error->second.value <= certain_to;
    const std::string found =
        error == reference.error.end()
            ? "not measured"
            : fmt::format("two routes and the closed form agree to {:.1e} m", error->second.value);
    return {"self-test: reference", good ? Health::well : Health::failed, found, good ? "" : advice};
}

Finding order_finding(const std::string& precision, const Engine& engine, const ProblemDescription& problem,
                      const Reference& reference) {
    const std::string topic = "self-test: " + precision;
    const double declared = find_named(engine.methods(), method_name)->order.configuration;
    std::map<long, double> errors;
    for (const long steps : {coarse, 2 * coarse, 4 * coarse}) {
        const Outcome outcome = engine.run(cell_of(problem, engine, steps), &reference, std::stop_token());
        const auto error = error_of(outcome);
        if (!error) {
            return {topic, Health::failed,
                    fmt::format("{} with {} steps: {} {}", method_name, steps, outcome.status, outcome.detail), advice};
        }
        errors[steps] = *error;
    }
    const auto order = [&](long steps) { return std::log2(errors[steps] / errors[2 * steps]); };
    const double first = order(coarse), second = order(2 * coarse);
    // Not beyond it, for that shows another method than the declared one.
    const bool good = std::abs(first - declared) <= tolerated_order && std::abs(second - declared) <= tolerated_order;
    return {topic, good ? Health::well : Health::failed,
            fmt::format("{} on {}: observed orders {:.2f}, {:.2f}, declared {}", method_name, problem_name, first,
                        second, declared),
            good ? "" : advice};
}

// Without quad precision a run of steps so fine that its error does not count stands for the reference.
std::vector<Finding> self_test_in_double(const Engine& engine, const ProblemDescription& problem) {
    Cell finest = cell_of(problem, engine, 32 * coarse);
    finest.metrics.clear();
    const Outcome outcome = engine.run(finest, nullptr, std::stop_token());
    const Finding missing{"self-test: quad", Health::missing, "this program is built without it: no references",
                          "build with -D KREISEL_BINARY128=ON"};
    if (!outcome.final) {
        return {missing, {"self-test: double", Health::failed, outcome.status + " " + outcome.detail, advice}};
    }
    const Reference reference{.state = *outcome.final, .error = {{metric, Number{}}}, .horizon = t_end};
    return {missing, order_finding("double", engine, problem, reference)};
}

}  // namespace

std::vector<Finding> self_test(const Engines& engines) {
    const auto problems = engines.binary64.problems();
    const ProblemDescription* problem = find_named(problems, problem_name);
    if (problem == nullptr) {
        return {{"self-test", Health::failed, fmt::format("there is no problem {}", problem_name), advice}};
    }
    if (!engines.has_quad()) { return self_test_in_double(engines.binary64, *problem); }
    const Reference reference =
        engines.quad().reference(problem_name, default_parameters(*problem), t_end, std::stop_token());
    return {reference_finding(reference), order_finding("double", engines.binary64, *problem, reference),
            order_finding("quad", engines.quad(), *problem, reference)};
}

}  // namespace kreisel
