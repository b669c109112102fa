// SPDX-License-Identifier: BSD-3-Clause
//
// Runs of the baselines that have a step control of their own, on the acceptance problems.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "engine/reference/reference.hpp"
#include "mechanics/model/scales.hpp"
#include "methods/control/stepper.hpp"
#include "tests/methods/stepping.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace peers {

/// Those that run in this precision.
inline std::vector<Method> baselines() {
    std::vector<Method> found;
    for (const Method& entry : methods())
        if (entry.description.name.starts_with("baseline/") && entry.factory.stepper) found.push_back(entry);
    return found;
}

/// The default options, and each word of each option.
inline std::vector<OptionValues> variants(const Method& entry) {
    std::vector<OptionValues> all = {stepping::default_options(entry.description.options)};
    for (const OptionDescription& option : entry.description.options)
        for (const std::string& word : option.choices) {
            if (OptionValue(word) == option.standard) continue;
            all.push_back(all.front());
            all.back()[option.name] = word;
        }
    return all;
}

inline std::string text(const OptionValues& options) {
    std::string all;
    for (const auto& [name, value] : options) all += " " + name + "=" + std::get<std::string>(value);
    return all;
}

/// A baseline on a system, which may be a double.
struct Approach {
    Approach(const Model& m, const std::string& formulation, const Method& entry, const OptionValues& options,
             const Real& tolerance, const std::string& projector = "none")
        : Approach(m, make_system(m, formulation), entry, options, tolerance, projector) {}

    Approach(const Model& m, std::unique_ptr<System> s, const Method& entry, const OptionValues& options,
             const Real& tolerance, const std::string& projector = "none")
        : model(m), system(std::move(s)), y(initial_state(*system, model)) {
        const ProjectionMethod& chosen = projection(projector);
        project = chosen.make(*system, stepping::default_options(chosen.description.options));
        stepper = bind_stepper(entry, *system, *project, {tolerance, extent(model), "pi"}, options);
    }

    /// To each of these times in turn; the first status that is not ok, or ok.
    Status run(const std::vector<Real>& times, long most = 1000000) {
        Status status = stepper->start(t, times.back(), y.data());
        for (const Real& limit : times)
            while (status == Status::ok && t != limit) {
                status = --most < 0 ? Status::step_too_small : stepper->step(t, limit, y.data());
                if ((limit - t) * (times.back() - begin) < 0) return Status::left_chart;  // beyond the limit
            }
        return status;
    }

    std::vector<BodyState> bodies() const {
        std::vector<BodyState> states(model.bodies.size());
        system->read(y.data(), states.data());
        return states;
    }
    bool finite() const {
        return std::all_of(y.begin(), y.end(), [](const Real& x) { return isfinite(x); });
    }

    Model model;
    std::unique_ptr<System> system;
    std::vector<Real> y;
    std::unique_ptr<Projection> project;
    std::unique_ptr<Stepper> stepper;
    Real t = 0, begin = 0;
};

/// Largest error at t = 1 s, of any quantity in its unit: motions of some metres and radians in a second.
inline Real error_at_1(const std::string& problem, const Approach& end) {
    static std::map<std::string, std::vector<BodyState>> known;
    if (!known.contains(problem)) known[problem] = reference_solution(models::standard(problem), 1).states;
    return stepping::worst(distance(end.bodies(), known.at(problem)));
}

}  // namespace peers
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
