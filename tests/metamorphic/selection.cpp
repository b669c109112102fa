// SPDX-License-Identifier: BSD-3-Clause
#include "tests/metamorphic/selection.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "mechanics/formulation.hpp"
#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {
namespace metamorphic {

namespace {

const std::vector<std::string> one_of_each_family = {"rkmk/rk4",
                                                     "crouch_grossman/cg3a",
                                                     "baseline/rk4_quaternion",
                                                     "rkmk/implicit_midpoint",
                                                     "symmetric_projection/midpoint",
                                                     "generalized_alpha/index2",
                                                     "multistep/bliedf2"};

bool contains(const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

/// The defaults, and with all methods each other value of a word option, the others at their defaults.
std::vector<OptionValues> variants(const std::vector<OptionDescription>& options, bool all) {
    std::vector<OptionValues> list = {{}};
    if (!all) return list;
    for (const OptionDescription& option : options)
        for (const std::string& choice : option.choices)
            if (OptionValue(choice) != option.standard) list.push_back({{option.name, choice}});
    return list;
}

/// Whether a system has constraints, and the rows that the projection needs.
bool applies(const ProjectionMethod& entry, const MethodDescription& method, const std::string& formulation,
             const System& system) {
    const ProjectionDescription& projection = entry.description;
    if (projection.name == "none") return true;
    if (method.meets_constraints() || system.constraints() == 0 || !entry.why_not(method).empty()) return false;
    if (!projection.formulations.empty() && !contains(projection.formulations, formulation)) return false;
    return !projection.ambient || system.has_ambient_jacobian();
}

/// Numbers of the pairs of a case that must be covered: any two of model, transformation, method, formulation,
/// projection.
class Pairs {
  public:
    std::vector<std::size_t> of(const Case& entry) {
        const std::string choice[] = {entry.model->name, entry.transformation->name, entry.combination.method,
                                      entry.combination.formulation, entry.combination.projection};
        std::vector<std::size_t> list;
        for (std::size_t i = 0; i < std::size(choice); ++i)
            for (std::size_t k = i + 1; k < std::size(choice); ++k)
                list.push_back(
                    number_.insert({std::to_string(10 * i + k) + choice[i] + "|" + choice[k], number_.size()})
                        .first->second);
        return list;
    }
    std::size_t count() const { return number_.size(); }

  private:
    std::map<std::string, std::size_t> number_;
};

/// Takes the case with the most new pairs until none is new. `met` marks the pairs that need no further case.
std::vector<Case> covering(const std::vector<Case>& all, Pairs& numbers, std::vector<bool>& met) {
    std::vector<Case> chosen;
    std::vector<std::vector<std::size_t>> pairs;
    for (const Case& entry : all) pairs.push_back(numbers.of(entry));
    met.resize(numbers.count());
    while (true) {
        std::size_t best = 0;
        std::ptrdiff_t most = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
            const auto fresh =
                std::count_if(pairs[i].begin(), pairs[i].end(), [&](std::size_t pair) { return !met[pair]; });
            if (fresh > most) most = fresh, best = i;
        }
        if (most == 0) return chosen;
        for (const std::size_t pair : pairs[best]) met[pair] = true;
        chosen.push_back(all[best]);
    }
}

/// Those that also run on a changed model: with other bodies or joints, some may not.
std::vector<Combination> common(const std::vector<Combination>& runs, const Model& model, const Model& changed,
                                bool all_methods) {
    if (model.bodies.size() == changed.bodies.size() && model.joints.size() == changed.joints.size()) return runs;
    std::set<std::string> others;
    for (const Combination& combination : combinations(changed, all_methods)) others.insert(to_text(combination));
    std::vector<Combination> both;
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(both),
                 [&](const Combination& combination) { return others.contains(to_text(combination)); });
    return both;
}

std::vector<Case> all_cases(const NamedModel& model, bool all_methods) {
    std::vector<Case> cases;
    const auto runs = combinations(model.model, all_methods);
    for (const Transformation& entry : transformations()) {
        const auto changed = entry.apply(model.model);
        if (!changed) continue;
        for (const Combination& combination : common(runs, model.model, changed->model, all_methods))
            cases.push_back({&model, &entry, combination});
    }
    return cases;
}

}  // namespace

std::string to_text(const Case& entry) {
    return entry.model->name + ", " + entry.transformation->name + ", " + to_text(entry.combination);
}

std::vector<Combination> combinations(const Model& model, bool all_methods) {
    std::vector<Combination> list;
    for (const Formulation& formulation : formulations()) {
        if (!formulation.why_not(model).empty()) continue;
        const auto system = make_system(model, formulation.name);
        for (const Method& entry : methods()) {
            const MethodDescription& method = entry.description;
            if (!all_methods && !contains(one_of_each_family, method.name)) continue;
            if (method.own_control) continue;  // constant steps only
            if (!method.formulations.empty() && !contains(method.formulations, formulation.name)) continue;
            if (entry.factory.declines && !entry.factory.declines(*system).empty()) continue;
            for (const ProjectionMethod& projection : projections()) {
                if (!applies(projection, method, formulation.name, *system)) continue;
                for (const OptionValues& options : variants(method.options, all_methods))
                    for (const OptionValues& how : variants(projection.description.options, all_methods))
                        list.push_back({method.name, formulation.name, projection.description.name, options, how});
            }
        }
    }
    return list;
}

std::vector<Case> select(Extent extent) {
    std::vector<Case> chosen;
    Pairs numbers;
    std::vector<bool> met;
    for (const NamedModel& model : named_models()) {
        std::vector<Case> cases = all_cases(model, extent == Extent::full);
        if (extent == Extent::pairwise) met.assign(met.size(), false);
        if (extent != Extent::full) cases = covering(cases, numbers, met);
        chosen.insert(chosen.end(), cases.begin(), cases.end());
    }
    return chosen;
}

}  // namespace metamorphic
}  // namespace KREISEL_PRECISION
}  // namespace kreisel
