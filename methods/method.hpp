// SPDX-License-Identifier: BSD-3-Clause
//
// What a method is, and how it is registered: one line in its own file. Lean on purpose: a method file needs no Eigen.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lie/real.hpp"
#include "lie/status.hpp"
#include "methods/description.hpp"
#include "methods/tableau.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class System;

/// Moves a state y in TG by one step. Work space is sized when method and system meet: a step allocates nothing.
class Integrator {
  public:
    virtual ~Integrator() = default;
    /// Called before the first step; methods with memory start it here.
    virtual Status start(const Real& /*t*/, const Real* /*y*/) { return Status::ok; }
    /// y(t) -> y(t + h) in place. Any status but ok leaves y as it was.
    virtual Status step(const Real& t, const Real& h, Real* y) = 0;
};

/// How a scheme combines its stages; the certification evaluates the declared scheme independently from this.
struct Scheme {
    enum class Kind { munthe_kaas, crouch_grossman } kind;
    Tableau tableau;
};

/// A method that can be bound to a system. The system outlives the integrator.
struct Factory {
    std::function<std::unique_ptr<Integrator>(System&, const OptionValues&, const MethodDescription&)> make;
    std::vector<OptionDescription> options = {};
    int stages = 0;  ///< solves of the dynamics per step
    std::optional<Scheme> scheme = {};
};

struct Method {
    MethodDescription description;
    Factory factory;
    std::string file;
};

const std::vector<Method>& methods();
/// Throws std::out_of_range for an unknown name.
const Method& method(const std::string& name);

/// Records a method; a static object of this type is what KREISEL_METHOD declares. What can throw is checked on first use.
struct MethodRegistration {
    MethodRegistration(const char* file, Factory factory, MethodDescription description);
};

/// KREISEL_METHOD(factory, {.name = "family/scheme", .order = p, .cites = {...}, .summary = "..."}).
#define KREISEL_METHOD(factory, ...) \
    static const ::kreisel::MethodRegistration kreisel_method_registration(__FILE__, factory, __VA_ARGS__)

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
