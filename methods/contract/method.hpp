// SPDX-License-Identifier: BSD-3-Clause
//
// What a method is, and how it is registered: one line in its own file. Lean on purpose: the file of a tableau sees
// neither Eigen nor the number type, and compiles in no time in every precision.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "methods/contract/description.hpp"
#include "methods/contract/scheme.hpp"
#include "methods/tableaus/tableau.hpp"
#include "support/registration.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class System;
class Integrator;
class Projection;
class Stepper;
struct Accuracy;

/// Makes the integrators of a method. Use Method::bind to get one: `make` by itself does not handle the turns
/// that torsion springs count.
struct Factory {
    std::function<std::unique_ptr<Integrator>(System&, const OptionValues&, const MethodDescription&)> make;
    std::vector<OptionDescription> options = {};
    int stages = 0;                     ///< solves of the dynamics per step
    std::optional<Scheme> scheme = {};  ///< the certification evaluates it independently
    /// The order under given options, where it is not the declared one.
    std::function<Order(const OptionValues&, const Order& declared)> order =
        [](const OptionValues&, const Order& declared) { return declared; };
    /// The same of its estimate (MethodDescription::estimate).
    std::function<int(const OptionValues&, int declared)> estimate = [](const OptionValues&, int declared) {
        return declared;
    };
    /// Of a method that chooses its steps by a control of its own (MethodDescription::own_control); then `make` is
    /// empty. System and projection outlive the stepper.
    std::function<std::unique_ptr<Stepper>(System&, Projection&, const Accuracy&, const OptionValues&,
                                           const MethodDescription&)>
        stepper = {};
    /// Why a combination of options does not apply; empty if it does. Throws OptionError for one that is wrong.
    std::function<std::string(const OptionValues&)> why_not = [](const OptionValues&) { return std::string(); };
    /// Moves states by exponentials of slopes only, in whatever group acts on them (methods/contract/state_space.hpp).
    /// The other methods decline systems on which another one than TG does.
    bool takes_actions = false;
    /// Why a system cannot be treated (rolling, dampers, moving supports, redundant rows, ...); empty if it can. None
    /// is asked where this is empty.
    std::function<std::string(const System&)> declines = {};
};

struct Method {
    MethodDescription description;
    Factory factory;
    std::string file;
    /// What it is under these options, which may decide order and estimate.
    MethodDescription under(const OptionValues& options) const;
    /// The method on a system, which outlives the integrator. Where torsion springs count full turns, a step can return
    /// turn_lost (mechanics/turns.hpp).
    std::unique_ptr<Integrator> bind(System& system, const OptionValues& options) const;
};

const std::vector<Method>& methods();
/// Throws std::out_of_range for an unknown name.
const Method& method(const std::string& name);

/// Records a method; a static object of this type is what KREISEL_METHOD declares. What can throw is checked on first
/// use.
struct MethodRegistration {
    MethodRegistration(const char* file, Factory factory, MethodDescription description);
};

/// KREISEL_METHOD(factory, {.name = "family/scheme", .order = p, .cites = {...}, .summary = "..."}).
#define KREISEL_METHOD(factory, ...) KREISEL_REGISTER(::kreisel::MethodRegistration, __FILE__, factory, __VA_ARGS__)

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
