// SPDX-License-Identifier: GPL-3.0-or-later
//
// What accuracy costs on the fast top of the literature: the error of the mass centre at t = 1 s and the CPU time of
// methods of kreisel, given as METHOD[;OPTION=VALUE]:FORMULATION[:PROJECTION], of ODE libraries on the hand-reduced
// top, and of general multibody engines. Each climbs its ladder of step counts or tolerances until its errors stay
// below the goal. Prints a line of CSV for each rung. tools/accuracy-per-cost adds instructions, and interpolates
// at the goal. The program as a whole links GSL, hence its licence.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>

#include "benchmarks/accuracy/contender.hpp"

/// What is timed; tools/accuracy-per-cost counts the instructions below this name.
extern "C" [[gnu::noinline]] bool accuracy_run(accuracy::Run& run) { return run.integrate(); }

namespace accuracy {

std::vector<double> step_counts(long first, long last) {
    std::vector<double> counts;
    for (const double n : ladder(static_cast<double>(first), std::sqrt(2.0), static_cast<double>(last)))
        counts.push_back(std::round(n));
    return counts;
}

std::vector<double> tolerances(double first, double last) { return ladder(first, std::sqrt(0.1), last); }

namespace {

/// At t = 1 s, by the two routes of kreisel's reference in quad; they agree to 22 digits.
constexpr std::array<double, 3> exact = {0.1733439640983860426, 0.6400885920705687829, -0.7484907911335813095};

struct Rung {
    const Contender* contender;
    double setting, error, cpu_s;
    long evaluations;
};

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// NaN where the integrator gave up.
double distance(const Run& run) {
    const std::array<double, 3> x = run.position();
    return std::hypot(x[0] - exact[0], x[1] - exact[1], x[2] - exact[2]);
}

Rung climb(const Contender& contender, double setting) {
    const auto run = contender.run(setting);
    const double begin = cpu_seconds();
    const bool arrived = accuracy_run(*run);
    const double cpu_s = cpu_seconds() - begin;
    return {&contender, setting, arrived ? distance(*run) : NAN, cpu_s, run->evaluations()};
}

void climb_ladder(const Contender& contender, double goal, std::vector<Rung>& rungs) {
    // One lucky error below the goal does not count, but for engines, which take long.
    const int enough = contender.kind == Contender::Kind::engine ? 1 : 2;
    int below = 0;
    for (const double setting : contender.settings) {
        rungs.push_back(climb(contender, setting));
        below = rungs.back().error <= goal ? below + 1 : 0;
        if (below == enough) return;
    }
}

std::vector<Contender> contenders(int count, char** names) {
    std::vector<Contender> all;
    const auto add = [&](std::vector<Contender> more) { std::move(more.begin(), more.end(), std::back_inserter(all)); };
    for (int i = 0; i < count; ++i) add(kreisel_contenders(names[i]));
    for (const auto& group :
         {odeint_contenders(), gsl_contenders(), simbody_contenders(), ida_contenders(), mujoco_contenders()})
        add(group);
    return all;
}

void measure(const std::vector<Contender>& all, double goal, int repeats) {
    std::vector<Rung> rungs;
    for (const Contender& contender : all) climb_ladder(contender, goal, rungs);
    for (int i = 1; i < repeats; ++i)  // in turns, so that a busy moment of the machine meets all alike
        for (Rung& rung : rungs) rung.cpu_s = std::min(rung.cpu_s, climb(*rung.contender, rung.setting).cpu_s);
    std::puts("kind,contender,by,setting,error [m],evaluations,cpu [s]");
    for (const Rung& rung : rungs)
        std::printf("%s,%s,%s,%.6g,%.4g,%ld,%.4g\n", name(rung.contender->kind).c_str(), rung.contender->name.c_str(),
                    rung.contender->by_steps ? "steps" : "tolerance", rung.setting, rung.error, rung.evaluations,
                    rung.cpu_s);
}

}  // namespace
}  // namespace accuracy

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fputs(
            "usage: bench_accuracy GOAL REPEATS [METHOD[;OPTION=VALUE]:FORMULATION[:PROJECTION]]...\n"
            "       GOAL in m; CPU times are the least of REPEATS runs\n",
            stderr);
        return 2;
    }
    try {
        accuracy::measure(accuracy::contenders(argc - 3, argv + 3), std::atof(argv[1]), std::atoi(argv[2]));
    } catch (const std::exception& e) {
        std::fprintf(stderr, "bench_accuracy: %s\n", e.what());
        return 2;
    }
}
