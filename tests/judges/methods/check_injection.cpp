// SPDX-License-Identifier: BSD-3-Clause
//
// NaN and infinity in the state, the forces, the masses and the joints, at the first, a middle and the last step of a
// run. A step that meets one must report it, or leave it in the state, which the caller checks after each step.
#include <algorithm>

#include "tests/judges/methods/checks.hpp"
#include "tests/judges/methods/poison.hpp"
#include "tests/judges/methods/runs.hpp"
#include "tests/judges/methods/switched_system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using namespace stepping;

namespace {

const int step_count = KREISEL_QUAD ? 3 : 10;
const Real step_size = Real(1) / 100;

/// What is injected into the i-th quantity of a run after some healthy steps: everything, and in quad, which is slow,
/// one of the three in turn, so that each quantity still meets each of them, and each step too.
std::vector<Real> poisons_for(std::size_t i, int healthy_steps) {
    const std::vector<Real> all = poisons();
    if (!KREISEL_QUAD) return all;
    return {all[(i + static_cast<std::size_t>(healthy_steps)) % all.size()]};
}

/// A method that has done `healthy_steps` steps on a system, the next one of which can be exchanged.
struct Patient {
    Patient(const Model& model, const Model& spoiled, const std::string& form, const Method& entry, int healthy_steps)
        : healthy(formulation(form).make(model)),
          sick(formulation(form).make(spoiled)),
          system(*healthy, *sick),
          integrator(entry.bind(system, default_options(entry.description.options))),
          y(initial_state(*healthy, model)),
          t(step_size * healthy_steps) {
        good = integrator->start(0, y.data()) == Status::ok;
        for (int i = 0; i < healthy_steps; ++i)
            good = good && integrator->step(step_size * i, step_size, y.data()) == Status::ok;
    }
    bool next_step_is_accepted() { return integrator->step(t, step_size, y.data()) == Status::ok && all_finite(y); }

    std::unique_ptr<System> healthy, sick;
    SwitchedSystem system;
    std::unique_ptr<Integrator> integrator;
    std::vector<Real> y;
    Real t;
    bool good;
};

std::string where(const std::string& what, const Real& poison, int step) {
    return what + " " + to_text(poison) + " in step " + std::to_string(step + 1) + " of " + std::to_string(step_count);
}

Objection system_objection(const Method& entry, const Model& model, const std::string& form, int healthy_steps) {
    // A spoiled stage, from the first on; steps with multipliers may need any number of solves. Steps in quad are slow,
    // and those of many stages run through five of them: all are seen in double, by the same code.
    const int solves = entry.description.form == Form::explicit_steps ? std::max(1, entry.description.stages) : 1;
    const int stride = KREISEL_QUAD && solves > 5 ? (solves - 1) / 4 : 1;
    const std::vector<Target> all = targets();
    for (const Target& target : all)
        for (const Real& poison : poisons_for(static_cast<std::size_t>(&target - all.data()), healthy_steps))
            for (int solve = 0; solve < solves; solve += stride) {
                Model spoiled = model;
                target.in(spoiled) = poison;
                Patient patient(model, spoiled, form, entry, healthy_steps);
                if (!patient.good) return "a healthy step fails";
                patient.system.solves_until_switch = solve;
                if (patient.next_step_is_accepted())
                    return where(target.name, poison, healthy_steps) + ", solve " + std::to_string(solve + 1);
            }
    return "";
}

Objection state_objection(const Method& entry, const Model& model, const std::string& form, int healthy_steps) {
    const std::size_t stride = KREISEL_QUAD ? 5 : 1;  // meets x, R, v and omega
    const auto size = static_cast<std::size_t>(make_system(model, form)->state_group().size());
    for (std::size_t i = 0; i < size; i += stride)
        for (const Real& poison : poisons_for(i, healthy_steps)) {
            Patient patient(model, model, form, entry, healthy_steps);
            if (!patient.good) return "a healthy step fails";
            patient.y[i] = poison;
            if (patient.next_step_is_accepted())
                return where("entry " + std::to_string(i) + " of the state", poison, healthy_steps);
        }
    return "";
}

}  // namespace

Objection injection_objection(const Method& entry) {
    for (const auto& [problem, form] : {std::pair("forced_heavy_top", "SO3"), std::pair("forced_heavy_top", "SO3xR3"),
                                        std::pair("double_pendulum", "SO3xR3"), std::pair("double_pendulum", "SE3")}) {
        if (!runs_on(entry, models::standard(problem), form)) continue;
        for (const int healthy_steps : {0, step_count / 2, step_count - 1})
            for (const auto judge : {system_objection, state_objection}) {
                const Objection objection = judge(entry, models::standard(problem), form, healthy_steps);
                if (!objection.empty()) return objection + " (" + problem + " as " + form + ")";
            }
    }
    return "";
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
