// SPDX-License-Identifier: BSD-3-Clause
//
// Projections onto the constraints, applied after a step of any one-step method; registered like methods, one file
// each.
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
    /// Moves y in TG onto the constraints at time t. Allocates nothing.
    virtual Status project(const Real& t, Real* y) = 0;
    /// Gauss-Newton iterations since construction.
    long iterations() const { return iterations_; }

  protected:
    long iterations_ = 0;
};

struct ProjectionMethod {
    ProjectionDescription description;
    std::function<std::unique_ptr<Projection>(System&, const OptionValues&)> make;
    std::string file;
};

const std::vector<ProjectionMethod>& projections();
/// Throws std::out_of_range for an unknown name.
const ProjectionMethod& projection(const std::string& name);

struct ProjectionRegistration {
    ProjectionRegistration(const char* file, ProjectionDescription description,
                           std::function<std::unique_ptr<Projection>(System&, const OptionValues&)> make);
};

/// KREISEL_PROJECTION({description}, make).
#define KREISEL_PROJECTION(...) KREISEL_REGISTER(::kreisel::ProjectionRegistration, __FILE__, __VA_ARGS__)

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
