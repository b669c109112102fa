// SPDX-License-Identifier: BSD-3-Clause
#include "tests/judges/steps/step_checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

const std::vector<StepCheck>& step_checks() {
    static const std::vector<StepCheck> all = {
        {"rkmk/implicit_midpoint", implicit_midpoint_step_objection},
        {"generalized_alpha/index2", [](const Method& method) { return generalised_alpha_step_objection(method); }},
        {"multistep/bliedf2", [](const Method& method) { return bliedf2_step_objection(method); }},
        {"baseline/rk4_quaternion", quaternion_step_objection},
        {"baseline/rk4_matrix", matrix_step_objection},
        {"baseline/rk4_euler_angles", euler_angles_step_objection}};
    return all;
}

bool covers(const std::string& entry, const std::string& method) {
    if (entry.ends_with('/')) return method.starts_with(entry);
    const std::string control = "control/" + entry.substr(entry.find('/') + 1) + "_";
    return method == entry || method.starts_with(control);
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
