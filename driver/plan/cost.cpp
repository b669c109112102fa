// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/cost.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "support/pattern.hpp"

namespace kreisel {

namespace {

// Fitted to "cpu_s" in the journals of the shipped orders_heavy_top, exp_vs_cayley, adaptive_pendulum, mechanisms,
// certification and certification_quad, run with -j 1 by a release build. A solve takes 0.15 us with n = 6 unknowns
// (velocities and rows), 0.2 to 0.4 at 18, 1.1 at 28, 2.7 at 56 (a chain), 8 at 60 (Bricard's mechanism); in quad 90 to
// 150 times as long. A stage of rkmk/gauss2 and its kin takes as long as six solves, in quad as 12 to 30. Steps to a
// tolerance are between 1 and 30 per second and power of the tolerance. References: --references-only of the same
// configs, without a cache.
constexpr double solve_s = 1e-7, entry_s = 1e-9;  // of a solve, and times n^2
constexpr double dense = 60;                      // unknowns from which on systems are sparse: time grows as n
constexpr double start_s = 2e-4;                  // of a cell: system, method, journal
constexpr double quad = 100;                      // to double
constexpr double newton = 5, quad_newton = 15;    // solves that an implicit stage takes as long as
constexpr double steps_to_tolerance = 10;         // per second, times tolerance^(-1/order)
constexpr double timed_s = 0.25;                  // least time of a cell whose time is taken
constexpr double reference_s = 0.04;              // per unknown and second
constexpr int most_freedoms = 64;                 // of which a two-form is measured

double unknowns(const SystemSummary& system) { return std::max(1, system.velocities + system.constraints.rows); }

// x^(1/p) for x >= 1, to some percent, of correctly rounded operations only: the last bits of std::pow differ between
// processors, and all machines must come to the same deal.
double root(double x, int p) {
    int exponent = 0;
    const double fraction = std::frexp(x, &exponent);
    const double logarithm = (exponent - 1 + (2 * fraction - 1)) / p;  // of base 2, linear within an octave
    const double whole = std::floor(logarithm);
    return std::ldexp(1 + (logarithm - whole), static_cast<int>(whole));
}

double steps_of(const PlannedCell& planned) {
    if (planned.tolerance <= 0) { return static_cast<double>(planned.steps); }
    const auto& declared = planned.run->identity.order;
    const int order = declared ? std::max(1, declared->configuration) : 1;
    const Cell& cell = planned.run->cell;
    return steps_to_tolerance * (cell.t_end - cell.t_begin()) * root(std::max(1.0, 1 / planned.tolerance), order);
}

// What metrics of structure take at the start and at the end: for the two-form, which the volume needs too, a step and
// differences of six along two columns for each degree of freedom (engine/structure/step_derivative.hpp); for a
// reversal two.
double probing_steps(const PlannedCell& planned, const MethodDescription& method, const SystemSummary& system) {
    if (planned.tolerance > 0 || method.keeps_memory) { return 0; }
    const auto asked = [&](std::string_view name, std::string_view uncertainty) {
        const std::vector<std::string>& metrics = planned.run->cell.metrics;
        return matches_any(metrics, name) || matches_any(metrics, uncertainty) ? 1 : 0;
    };
    const int forms = asked("structure.symplectic", "structure.symplectic.uncertainty") +
                      asked("structure.volume", "structure.volume.uncertainty");
    const int reversals = asked("structure.reversal", "structure.reversal.uncertainty");
    const int freedoms = system.velocities - system.constraints.rank;
    const int of_form = freedoms > most_freedoms ? 0 : 12 * freedoms + 1;
    return 2.0 * (forms * of_form + 2 * reversals);
}

// Measuring and projecting a step cost about as much as a stage.
double solves_per_step(const PlannedCell& planned, const MethodDescription& method) {
    const Cell& cell = planned.run->cell;
    const double iterations = planned.quad() ? quad_newton : newton;
    const double stages = std::max(1, method.stages) * (method.is_implicit() ? iterations : 1);
    return stages + (cell.metrics.empty() ? 0 : 1) + (cell.projection == "none" ? 0 : 1);
}

}  // namespace

double cost_of(const PlannedCell& planned, const MethodDescription& method, const SystemSummary& system) {
    if (!planned.skip_reason().empty()) { return start_s; }
    const double n = unknowns(system);
    const double solve = (solve_s + entry_s * n * std::min(n, dense)) * (planned.quad() ? quad : 1);
    const double steps = steps_of(planned) + probing_steps(planned, method, system);
    const double run = steps * solves_per_step(planned, method) * solve;
    const bool is_timed = planned.run->cell.timed || planned.run->cell.repeated;
    return start_s + run + (is_timed ? std::max(timed_s, (timing_rounds - 1) * run) : 0);
}

double first_round_share(const PlannedCell& planned) {
    const Cell& cell = planned.run->cell;
    if (!cell.timed && !cell.repeated) { return 1; }
    const bool is_short = planned.weight * (timing_rounds - 1) < timed_s * timing_rounds;
    // A short run is repeated in each round; beside that, the run that is measured counts for nothing.
    return cell.timed || is_short ? 1.0 / timing_rounds : 2.0 / (timing_rounds + 1);
}

double cost_of(const PlannedReference& planned, const SystemSummary& system) {
    const double t_begin = planned.begin ? planned.begin->t.value : 0;
    return reference_s * (planned.t_end - t_begin) * unknowns(system);
}

}  // namespace kreisel
