// SPDX-License-Identifier: BSD-3-Clause
//
// Projections onto the constraints, applied after a step of any one-step method; registered like methods, one file
// each. Stabilisations stand among them: they change the equations that the method integrates, and no state.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lie/real.hpp"
#include "lie/status.hpp"
#include "methods/contract/description.hpp"
#include "support/registration.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class System;

class Projection {
  public:
    virtual ~Projection() = default;
    /// Called before the first step, and whenever y is not what the last step left.
    virtual void start() {}
    /// Moves y in TG onto the constraints at time t, after a step. Allocates nothing.
    virtual Status project(const Real& t, Real* y) = 0;
    /// The step whose state was projected last is not taken after all: it does not count.
    virtual void retract() {}
    /// Gauss-Newton iterations since construction.
    long iterations() const { return iterations_; }

  protected:
    long iterations_ = 0;
};

/// Leaves states as they are.
class NoProjection final : public Projection {
  public:
    Status project(const Real&, Real*) override { return Status::ok; }
};

using MakeProjection = std::function<std::unique_ptr<Projection>(System&, const OptionValues&)>;

/// What a stabilisation does in place of moving states.
struct Stabilisation {
    /// The system that the method integrates instead of the given one, which outlives it. Solves count in both.
    std::function<std::unique_ptr<System>(System&, const OptionValues&)> change = {};
    /// Why a method does not integrate what has been changed; empty if it does.
    std::function<std::string(const MethodDescription&)> why_not = {};
};

struct ProjectionMethod {
    ProjectionDescription description;
    MakeProjection make;
    std::string file;
    Stabilisation stabilisation = {};

    bool stabilises() const { return static_cast<bool>(stabilisation.change); }
    /// What a method integrates: null where it is the system itself.
    std::unique_ptr<System> changed(System& system, const OptionValues& options) const;
    /// Why it does not go with a method; empty if it does.
    std::string why_not(const MethodDescription& method) const;
};

const std::vector<ProjectionMethod>& projections();
/// Throws std::out_of_range for an unknown name.
const ProjectionMethod& projection(const std::string& name);

/// Projections get the option `every` beside their own: k projects after each k-th step, of those accepted.
struct ProjectionRegistration {
    ProjectionRegistration(const char* file, ProjectionDescription description, MakeProjection make);
    ProjectionRegistration(const char* file, ProjectionDescription description, Stabilisation stabilisation);
};

/// KREISEL_PROJECTION({description}, make), or a Stabilisation in place of `make`.
#define KREISEL_PROJECTION(...) KREISEL_REGISTER(::kreisel::ProjectionRegistration, __FILE__, __VA_ARGS__)

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
