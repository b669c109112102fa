// SPDX-License-Identifier: BSD-3-Clause
//
// The problem `chain` with N links: forward dynamics and steps of kreisel, of Simbody [sherman2011] and of a kernel
// written by hand for this chain only, in one run. All forward dynamics must agree before any is timed. Debian's
// Simbody is compiled for generic x86-64 with assertions; it is measured as users get it.
// Use --benchmark_filter=/64$ to select, --benchmark_repetitions=5
// --benchmark_enable_random_interleaving=true on a loaded machine.
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <random>

#include "benchmarks/chain_kernel.hpp"
#include "benchmarks/chain_table.hpp"
#include "lie/so3.hpp"
#include "mechanics/formulation.hpp"
#include "methods/simulation.hpp"
#include "problems/problem.hpp"
#include "tests/peers/simbody/translate.hpp"

using namespace kreisel;

namespace {

Model chain(int links) {
    const Problem& chain = problem("chain");
    ParameterValues values = default_parameters(chain.description);
    values["links"] = static_cast<double>(links);
    return chain.build(Parameters(values));
}

/// The chain in a random pose, with random link velocities; the same for every contender.
std::vector<BodyState> tangle(const Model& model) {
    std::mt19937 engine(7);
    const auto number = [&] { return static_cast<Real>(engine() % 2097152) / 1048576 - 1; };
    std::vector<BodyState> bodies;
    Vec3 end = Vec3::Zero(), velocity = Vec3::Zero();
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
        const Vec3 r = model.joints[i].r_second;
        BodyState body{.R = SO3::exp(2 * Vec3(number(), number(), number())),
                       .omega = 3 * Vec3(number(), number(), number())};
        body.x = end - body.R * r;
        body.v = velocity - body.R * body.omega.cross(r);
        end = body.x - body.R * r;
        velocity = body.v - body.R * body.omega.cross(r);
        bodies.push_back(body);
    }
    return bodies;
}

struct Kreisel {
    Kreisel(const Model& model, const std::vector<BodyState>& bodies, const std::string& formulation)
        : system(make_system(model, formulation)),
          y(static_cast<std::size_t>(system->state_group().size())),
          dv(static_cast<std::size_t>(system->velocities())) {
        system->write(bodies.data(), y.data());
    }
    Status evaluate() { return system->evaluate(0, y.data(), system->v(y.data()), dv.data()); }

    std::unique_ptr<System> system;
    std::vector<Real> y, dv;
};

/// Largest difference of two lists, relative to the largest entry of the first.
Real difference(const std::vector<Real>& a, const std::vector<Real>& b) {
    Real largest = 0, size = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        size = std::max(size, std::abs(a[i]));
        largest = std::isnan(b[i]) ? b[i] : std::max(largest, std::abs(a[i] - b[i]));
    }
    return largest / size;
}

void must_agree(const char* contender, std::size_t links, const std::vector<Real>& a, const std::vector<Real>& b) {
    const Real d = difference(a, b);
    if (d <= 1e-10) return;
    std::fprintf(stderr, "bench_chain: %s differs from kreisel by %.3g on %zu links\n", contender, d, links);
    std::exit(1);
}

std::vector<Real> flat(const std::vector<outside::Acceleration>& list) {
    std::vector<Real> all;
    for (const outside::Acceleration& a : list)
        for (const Vec3& part : {a.linear, a.angular}) all.insert(all.end(), part.data(), part.data() + 3);
    return all;
}

/// v' of SE3 as that of SO3xR3: x'' = R (V' + omega x V).
std::vector<Real> in_space(std::vector<Real> dv, const std::vector<BodyState>& bodies) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        const BodyState& b = bodies[i];
        store(Vec3(b.R * (vec3(&dv[6 * i]) + b.omega.cross(b.R.transpose() * b.v))), &dv[6 * i]);
    }
    return dv;
}

std::vector<Real> by_hand(const Model& model, const Kreisel& at) {
    bench::ChainKernel kernel(model);
    std::vector<Real> dv(at.dv.size(), std::nan(""));
    kernel.evaluate(at.y.data(), at.system->v(at.y.data()), dv.data());
    return dv;
}

/// Ends the program if the contenders' accelerations differ.
void check(const Model& model, bool with_simbody) {
    const auto bodies = tangle(model);
    Kreisel mixed(model, bodies, "SO3xR3"), screws(model, bodies, "SE3");
    if (mixed.evaluate() != Status::ok || screws.evaluate() != Status::ok) std::exit(1);
    must_agree("SE3", bodies.size(), mixed.dv, in_space(screws.dv, bodies));
    must_agree("the kernel", bodies.size(), mixed.dv, by_hand(model, mixed));
    if (!with_simbody) return;
    outside::Simbody simbody(outside::translate(model));
    simbody.set(outside::translate(bodies));
    must_agree("Simbody", bodies.size(), mixed.dv, flat(simbody.accelerations()));
}

/// Calls `once` as often as Google Benchmark requests.
template <class Once>
void time(benchmark::State& state, int links, Once once) {
    for (auto _ : state) once();
    state.counters["per_body"] = benchmark::Counter(links * static_cast<double>(state.iterations()),
                                                    benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void dynamics(benchmark::State& state, int links, const std::string& formulation) {
    const Model model = chain(links);
    Kreisel kreisel(model, tangle(model), formulation);
    time(state, links, [&] {
        benchmark::DoNotOptimize(kreisel.evaluate());
        benchmark::ClobberMemory();
    });
}

void dynamics_by_hand(benchmark::State& state, int links) {
    const Model model = chain(links);
    Kreisel kreisel(model, tangle(model), "SO3xR3");
    bench::ChainKernel kernel(model);
    time(state, links, [&] {
        kernel.evaluate(kreisel.y.data(), kreisel.system->v(kreisel.y.data()), kreisel.dv.data());
        benchmark::DoNotOptimize(kreisel.dv.data());
        benchmark::ClobberMemory();
    });
}

outside::Simbody tangled_simbody(int links) {
    const Model model = chain(links);
    outside::Simbody simbody(outside::translate(model));
    simbody.set(outside::translate(tangle(model)));
    return simbody;
}

void simbody_dynamics(benchmark::State& state, int links) {
    outside::Simbody simbody = tangled_simbody(links);
    time(state, links, [&] { simbody.evaluate(); });
}

constexpr double step_size = 1e-6;  // so short that no run leaves the neighbourhood of its start

void step(benchmark::State& state, int links, const std::string& formulation) {
    const Model model = chain(links);
    Simulation simulation(model, {.formulation = formulation, .method = "rkmk/rk4"});
    simulation.restart(0, Kreisel(model, tangle(model), formulation).y);
    time(state, links, [&] {
        if (simulation.step(step_size) != Status::ok) state.SkipWithError("the step failed");
    });
}

void simbody_step(benchmark::State& state, int links) {
    outside::Simbody simbody = tangled_simbody(links);
    time(state, links, [&] { simbody.step(step_size); });
}

void add(const std::string& contender, int links, void (*run)(benchmark::State&, int)) {
    benchmark::RegisterBenchmark((contender + "/" + std::to_string(links)).c_str(), run, links);
}
void add(const std::string& contender, int links, void (*run)(benchmark::State&, int, const std::string&),
         const std::string& formulation) {
    benchmark::RegisterBenchmark((contender + "/" + formulation + "/" + std::to_string(links)).c_str(), run, links,
                                 formulation);
}

void register_all() {
    constexpr int largest_of_simbody = 256;
    for (const int links : {1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096, 10000}) {
        const bool with_simbody = links <= largest_of_simbody;
        check(chain(links), with_simbody);
        for (const char* formulation : {"SO3xR3", "SE3"}) add("dynamics/kreisel", links, dynamics, formulation);
        add("dynamics/by hand", links, dynamics_by_hand);
        if (with_simbody) add("dynamics/Simbody", links, simbody_dynamics);
        for (const char* formulation : {"SO3xR3", "SE3"}) add("step of rkmk/rk4", links, step, formulation);
        if (with_simbody) add("step of RK4/Simbody", links, simbody_step);
    }
}

}  // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    register_all();
    bench::Table table;
    benchmark::RunSpecifiedBenchmarks(&table);
}
