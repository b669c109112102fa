// SPDX-License-Identifier: BSD-3-Clause
#include "methods/contract/method.hpp"

#include <algorithm>
#include <stdexcept>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::vector<Method>& registry() {
    static std::vector<Method> all;
    return all;
}

}  // namespace

MethodRegistration::MethodRegistration(const char* file, Factory factory, MethodDescription description) {
    description.options = factory.options;
    description.stages = factory.stages;
    registry().push_back({std::move(description), std::move(factory), file});
}

const std::vector<Method>& methods() {
    static const std::vector<Method> sorted = [] {
        auto all = registry();
        std::sort(all.begin(), all.end(),
                  [](const Method& a, const Method& b) { return a.description.name < b.description.name; });
        return all;
    }();
    return sorted;
}

const Method& method(const std::string& name) {
    for (const Method& entry : methods())
        if (entry.description.name == name) return entry;
    throw std::out_of_range("no method \"" + name + "\"");
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
