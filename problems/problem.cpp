// SPDX-License-Identifier: BSD-3-Clause
#include "problems/problem.hpp"

#include "support/registered.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

ProblemRegistration::ProblemRegistration(const char* file, Model (*build)(const Parameters&),
                                         ProblemDescription description,
                                         std::vector<BodyState> (*closed_form)(const Parameters&, const Real&)) {
    description.closed_form = closed_form != nullptr;
    Registered<Problem>::add({std::move(description), build, closed_form, file});
}

int Parameters::count(const std::string& name) const {
    const double value = std::get<double>(values_.at(name));
    if (!(value >= 1 && value <= largest_parameter_count) || value != static_cast<int>(value))
        throw ParameterError("/" + name, "expected a whole number from 1 to 1,000,000, got " + std::to_string(value));
    return static_cast<int>(value);
}

const std::vector<Problem>& problems() { return Registered<Problem>::all(); }

const Problem& problem(const std::string& name) { return Registered<Problem>::named(name, "problem"); }

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
