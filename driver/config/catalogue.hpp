// SPDX-License-Identifier: BSD-3-Clause
//
// What there is to name in a config, requested from the engine once.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "engine/engine.hpp"

namespace kreisel {

/// The two precisions, injected so that tests can bring their own.
struct Engines {
    const Engine& binary64;
    const Engine& binary128;
    const Engine& of(const std::string& precision) const { return precision == "quad" ? binary128 : binary64; }
};

/// The entry called `name`, or null.
template <class Description>
const Description* find_named(const std::vector<Description>& all, const std::string& name) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
    return found == all.end() ? nullptr : &*found;
}

template <class Description>
std::vector<std::string> names_of(const std::vector<Description>& all) {
    std::vector<std::string> names;
    names.reserve(all.size());
    for (const auto& one : all) { names.push_back(one.name); }
    return names;
}

/// Patterns for several names: "*" for all, "family/*" for those of a family.
template <class Description>
std::vector<std::string> wildcards_of(const std::vector<Description>& all) {
    std::vector<std::string> wildcards = {"*"};
    for (const auto& one : all) {
        const std::string family = one.name.substr(0, one.name.find('/') + 1) + "*";
        if (std::find(wildcards.begin(), wildcards.end(), family) == wildcards.end()) { wildcards.push_back(family); }
    }
    return wildcards;
}

/// The descriptions of all that is registered.
struct Catalogue {
    std::vector<ProblemDescription> problems;
    std::vector<MethodDescription> methods;
    std::vector<ProjectionDescription> projections;
    std::vector<FormulationDescription> formulations;

    explicit Catalogue(const Engine& engine)
        : problems(engine.problems()),
          methods(engine.methods()),
          projections(engine.projections()),
          formulations(engine.formulations()) {}
};

}  // namespace kreisel
