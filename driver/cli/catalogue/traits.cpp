// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/catalogue/traits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "records/json/diagnostics.hpp"
#include "support/errors.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

constexpr Property all_properties[] = {Property::symplectic, Property::symmetric, Property::momentum, Property::energy,
                                       Property::constraints};

MethodTrait trait_of(Form form, const char* name, const char* summary) {
    return {name, summary, [form](const MethodDescription& method) { return method.form == form; }};
}

std::vector<MethodTrait> all_traits() {
    std::vector<MethodTrait> traits;
    for (const Property property : all_properties) {
        const std::string word = name(property);
        traits.push_back({word, fmt::format("Only methods that declare to be {} on some class of systems", word),
                          [property](const MethodDescription& method) { return method.claims(property); }});
    }
    traits.push_back(trait_of(Form::explicit_steps, "explicit", "Only explicit methods"));
    traits.push_back(trait_of(Form::half_explicit, "half-explicit", "Only half-explicit methods"));
    traits.push_back(trait_of(Form::implicit, "implicit", "Only implicit methods"));
    traits.push_back({"adaptive", "Only methods that can choose their steps to a tolerance",
                      [](const MethodDescription& method) { return method.estimate > 0 || method.own_control; }});
    return traits;
}

std::string family_of(const MethodDescription& method) { return method.name.substr(0, method.name.find('/')); }

void require_family(const std::vector<MethodDescription>& methods, const std::string& family) {
    std::vector<std::string> families;
    for (const MethodDescription& method : methods) {
        const std::string one = family_of(method);
        if (std::find(families.begin(), families.end(), one) == families.end()) { families.push_back(one); }
    }
    if (std::find(families.begin(), families.end(), family) != families.end()) { return; }
    const std::string nearest = nearest_name(family, families);
    throw UsageError(fmt::format("--family: expected one of {}, got {}{}", listed(families), in_quotes(family),
                                 nearest.empty() ? "" : "; did you mean " + in_quotes(nearest) + "?"));
}

bool has_all(const MethodDescription& method, const std::vector<std::string>& names) {
    const auto& traits = method_traits();
    return std::all_of(traits.begin(), traits.end(), [&](const MethodTrait& trait) {
        return std::find(names.begin(), names.end(), trait.name) == names.end() || trait.holds(method);
    });
}

}  // namespace

const std::vector<MethodTrait>& method_traits() {
    static const std::vector<MethodTrait> traits = all_traits();
    return traits;
}

std::vector<MethodDescription> selected(const std::vector<MethodDescription>& methods, const MethodFilter& filter) {
    if (!filter.family.empty()) { require_family(methods, filter.family); }
    std::vector<MethodDescription> some;
    std::copy_if(methods.begin(), methods.end(), std::back_inserter(some), [&](const MethodDescription& method) {
        return (filter.family.empty() || family_of(method) == filter.family) && has_all(method, filter.traits);
    });
    return some;
}

}  // namespace kreisel
