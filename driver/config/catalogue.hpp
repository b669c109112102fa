// SPDX-License-Identifier: BSD-3-Clause
//
// What there is to name in a config, requested from the engine once.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "engine/engine.hpp"
#include "support/errors.hpp"

namespace kreisel {

/// The precisions, injected so that tests can bring their own. A program may be built without quad precision
/// (KREISEL_BINARY128=OFF); it computes no references then.
class Engines {
  public:
    Engines(const Engine& narrow, const Engine& wide) : binary64(narrow), wide_(&wide) {}
    explicit Engines(const Engine& narrow) : binary64(narrow) {}

    const Engine& binary64;
    bool has_quad() const { return wide_ != nullptr; }
    /// Throws UsageError where there is none.
    const Engine& quad() const {
        if (wide_ == nullptr) {
            throw UsageError(
                "expected a kreisel with quad precision, got one that is built without it "
                "(KREISEL_BINARY128=OFF): it computes in double and makes no references");
        }
        return *wide_;
    }
    const Engine& of(const std::string& precision) const { return precision == "quad" ? quad() : binary64; }
    /// Identifies the code that computes references, or would (Engine::reference_digest).
    std::string reference_digest() const { return (wide_ == nullptr ? binary64 : *wide_).reference_digest(); }

  private:
    const Engine* wide_ = nullptr;
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
