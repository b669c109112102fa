// SPDX-License-Identifier: BSD-3-Clause
//
// What the configs of published numbers give here, each run once.
#pragma once

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "driver/cli/certify/trials.hpp"
#include "driver/cli/published/agreement.hpp"

namespace kreisel {

class PublishedRuns {
  public:
    PublishedRuns(const Engines& engines, std::ostream& messages) : engines_(engines), messages_(messages) {}

    /// One quantity, of each cell, formulation or refinement of the config that counts:
    ///   a column of results.csv                  of each cell that is ok, "final.top.x.2 [m]"
    ///   space.BODY.omega.K [rad/s]               component K of R omega, the angular velocity in space axes
    ///   initial.energy [J]                       |E_0|
    ///   order.METRIC                             the observed order, "order.error.position"
    ///   eigenvalue.N.real, eigenvalue.N.imaginary   the N-th of the linearised motion, in each formulation
    /// Throws UsageError where the config has no such quantity.
    std::vector<std::string> find(const PublishedValue& value);

  private:
    const Plan& plan(const std::string& config);
    /// The folder with the results of a config.
    std::filesystem::path folder_of(const std::string& config);
    std::vector<std::string> cells(const PublishedValue& value);
    std::vector<std::string> orders(const PublishedValue& value);
    std::vector<std::string> eigenvalues(const PublishedValue& value);
    const std::vector<Linearisation>& linearised(const std::string& config);

    const Engines& engines_;
    std::ostream& messages_;
    TemporaryFolder folder_;
    std::map<std::string, Plan> plans_;
    std::map<std::string, std::filesystem::path> folders_;
    std::map<std::string, std::vector<Linearisation>> linearised_;
};

}  // namespace kreisel
