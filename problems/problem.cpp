// SPDX-License-Identifier: BSD-3-Clause
#include "problems/problem.hpp"

#include <algorithm>
#include <stdexcept>

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

std::vector<Problem>& registry() {
    static std::vector<Problem> all;
    return all;
}

}  // namespace

ProblemRegistration::ProblemRegistration(const char* file, Model (*build)(const Parameters&),
                                         ProblemDescription description,
                                         std::vector<BodyState> (*closed_form)(const Parameters&, const Real&)) {
    description.closed_form = closed_form != nullptr;
    registry().push_back({std::move(description), build, closed_form, file});
}

int Parameters::count(const std::string& name) const {
    const double value = std::get<double>(values_.at(name));
    if (!(value >= 1 && value <= largest_parameter_count) || value != static_cast<int>(value))
        throw ParameterError("/" + name, "expected a whole number from 1 to 1,000,000, got " + std::to_string(value));
    return static_cast<int>(value);
}

const std::vector<Problem>& problems() {
    static const std::vector<Problem> sorted = [] {
        auto all = registry();
        std::sort(all.begin(), all.end(),
                  [](const Problem& a, const Problem& b) { return a.description.name < b.description.name; });
        return all;
    }();
    return sorted;
}

const Problem& problem(const std::string& name) {
    for (const Problem& entry : problems())
        if (entry.description.name == name) return entry;
    throw std::out_of_range("no problem \"" + name + "\"");
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
