// SPDX-License-Identifier: BSD-3-Clause
//
// NaN and infinity in the state, the masses and the joints, met by a projection after the first, a middle and the last
// step of a run: it must report them, or leave them in the state. What a projection does not read cannot affect it,
// and may go unnoticed.
#include "tests/judges/methods/checks.hpp"
#include "tests/judges/methods/poison.hpp"
#include "tests/judges/methods/runs.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

using namespace stepping;

namespace {

const int steps = KREISEL_QUAD ? 3 : 10;
const Real h = Real(1) / 100;

/// The defaults, and each other word of each option.
std::vector<OptionValues> variants(const std::vector<OptionDescription>& options) {
    std::vector<OptionValues> all = {default_options(options)};
    for (const OptionDescription& option : options)
        for (const std::string& word : option.choices) {
            if (OptionValue(word) == option.standard) continue;
            all.push_back(default_options(options));
            all.back()[option.name] = word;
        }
    return all;
}

/// The result of a projection for a state, and whether the caller accepts it.
struct Result {
    bool accepted;
    std::vector<Real> y;
};

struct Case {
    const ProjectionMethod& entry;
    const OptionValues& options;
    const std::string& form;
    const Model& model;
    std::vector<Real> y;  ///< off the constraints

    Result of(const Model& described, std::vector<Real> state) const {
        const auto system = formulation(form).make(described);
        const auto projector = entry.make(*system, options);
        const bool ok = projector->project(h, state.data()) == Status::ok;
        return {ok && all_finite(state), std::move(state)};
    }
};

/// The state after some steps and projections, velocities then off the constraints by about 1e-3 and positions by the
/// step that follows them.
std::vector<Real> disturbed_state(const ProjectionMethod& entry, const OptionValues& options, const Model& model,
                                  const std::string& form, int healthy_steps) {
    Trip trip(model, form, method("rkmk/rk4"));
    trip.project = entry.make(*trip.system, options);
    if (trip.run(h * healthy_steps, healthy_steps) != Status::ok) return {};
    Real* v = trip.system->v(trip.y.data());
    for (int i = 0; i < trip.system->velocities(); ++i) v[i] += Real(i % 5 - 2) / 1000;
    std::vector<Real> move(v, v + trip.system->velocities());
    for (Real& x : move) x *= h / 10;
    trip.system->group().append_exp(trip.y.data(), move.data(), trip.y.data());
    return trip.y;
}

Objection objection_on(const Case& here) {
    const Result healthy = here.of(here.model, here.y);
    if (!healthy.accepted) return "fails on a healthy state";
    for (const Real& poison : poisons()) {
        for (const Target& target : targets()) {
            Model spoiled = here.model;
            target.in(spoiled) = poison;
            const Result result = here.of(spoiled, here.y);
            if (result.accepted && result.y != healthy.y) return std::string(target.name) + " " + to_text(poison);
        }
        for (std::size_t i = 0; i < here.y.size(); ++i) {
            std::vector<Real> spoiled = here.y;
            spoiled[i] = poison;
            if (here.of(here.model, spoiled).accepted)
                return "entry " + std::to_string(i) + " of the state " + to_text(poison);
        }
    }
    return "";
}

}  // namespace

Objection projection_injection_objection(const ProjectionMethod& entry) {
    const auto& only = entry.description.formulations;
    for (const auto& [problem, form] : {std::pair<std::string, std::string>("forced_heavy_top", "SO3xR3"),
                                        {"double_pendulum", "SO3xR3"},
                                        {"double_pendulum", "SE3"}}) {
        if (!only.empty() && std::find(only.begin(), only.end(), form) == only.end()) continue;
        const Model model = models::standard(problem);
        for (const OptionValues& options : variants(entry.description.options))
            for (const int healthy_steps : {1, steps / 2, steps}) {
                const auto y = disturbed_state(entry, options, model, form, healthy_steps);
                const Objection objection =
                    y.empty() ? "a healthy run fails" : objection_on({entry, options, form, model, y});
                if (!objection.empty())
                    return objection + " after step " + std::to_string(healthy_steps) + " of " + std::to_string(steps) +
                           " (" + problem + " as " + form + ")";
            }
    }
    return "";
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
