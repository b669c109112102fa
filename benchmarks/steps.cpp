// SPDX-License-Identifier: BSD-3-Clause
//
// Nanoseconds per step of every method on every problem and formulation, no projection, no metrics.
// Use --benchmark_filter=heavy_top/SO3xR3 to select.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "methods/simulation.hpp"
#include "problems/problem.hpp"

using namespace kreisel;

namespace {

Model standard(const Problem& problem) {
    return problem.build(Parameters(demonstration_parameters(problem.description)));
}

void step(benchmark::State& state, const Model& model, const std::string& formulation, const Method& method) {
    Simulation simulation(model, {.formulation = formulation, .method = method.description.name});
    // Short steps, restarted now and then, so that drift does not lead into a singularity.
    const Real h = Real(1) / 100000;
    const std::vector<Real> start = simulation.state();
    long i = 0;
    for (auto _ : state) {
        if (i % 10000 == 0) simulation.restart(0, start);
        if (simulation.step(h) != Status::ok) state.SkipWithError("the step failed");
        ++i;
    }
    benchmark::DoNotOptimize(simulation.q());
}

void register_all() {
    for (const Problem& problem : problems()) {
        const Model model = standard(problem);
        for (const Formulation& entry : formulations()) {
            if (!entry.why_not(model).empty()) continue;
            for (const Method& method : methods()) {
                if (method.description.own_control) continue;
                const auto& only = method.description.formulations;
                if (!only.empty() && std::find(only.begin(), only.end(), entry.name) == only.end()) continue;
                const std::string name = problem.description.name + "/" + entry.name + "/" + method.description.name;
                benchmark::RegisterBenchmark(name.c_str(), [model, &entry, &method](benchmark::State& state) {
                    step(state, model, entry.name, method);
                });
            }
        }
    }
}

}  // namespace

int main(int argc, char** argv) {
    register_all();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
}
