// SPDX-License-Identifier: BSD-3-Clause
//
// One-step checks of methods that declare no scheme: each compares steps of the running method with the published
// equations, coded independently, and registers itself in its own file.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "support/registered.hpp"
#include "support/registration.hpp"
#include "tests/judges/methods/checks.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct StepCheck {
    std::string name;  ///< of the method that it knows, or of a family with its slash: "family/"
    std::function<Objection(const Method&)> objection;
    /// Of an explicit method: why it has no order conditions to check.
    std::string without_conditions = {};
};
const std::vector<StepCheck>& step_checks();
/// Null for a method that no check knows.
const StepCheck* step_check_of(const Method& method);

/// Whether `entry`, a method or "family/", covers the method. A control "control/<scheme>_<fault>" counts as what it
/// claims to be, "<family>/<scheme>".
bool covers(const std::string& entry, const std::string& method);

/// A static object of this type registers a check.
struct StepCheckRegistration {
    StepCheckRegistration(std::string name, std::function<Objection(const Method&)> objection,
                          std::string without_conditions = {}) {
        Registered<StepCheck>::add({std::move(name), std::move(objection), std::move(without_conditions)});
    }
};

/// KREISEL_STEP_CHECK("family/scheme", objection), and for explicit methods the reason why they have no order
/// conditions.
#define KREISEL_STEP_CHECK(...) KREISEL_REGISTER(::kreisel::StepCheckRegistration, __VA_ARGS__)

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
