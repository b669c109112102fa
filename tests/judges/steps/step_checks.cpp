// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

const std::vector<StepCheck>& step_checks() { return Registered<StepCheck>::all(); }

const StepCheck* step_check_of(const Method& method) {
    for (const StepCheck& check : step_checks())
        if (covers(check.name, method.description.name)) return &check;
    return nullptr;
}

bool covers(const std::string& entry, const std::string& method) {
    if (entry.ends_with('/')) return method.starts_with(entry);
    const std::string control = "control/" + entry.substr(entry.find('/') + 1) + "_";
    return method == entry || method.starts_with(control);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
