// SPDX-License-Identifier: BSD-3-Clause
//
// What the engines say of the problems of a plan in its formulations.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "engine/engine.hpp"

namespace kreisel {

/// Summaries in the order in which they are added: that of the problems, and of the formulations for each. Equal ones
/// are kept once, without what their problems warn of and the condition of their constraints.
class PlannedSystems {
  public:
    using Shared = std::shared_ptr<const SystemSummary>;

    void add(SystemSummary summary);
    /// Of the place in the order.
    const Shared& at(std::size_t index) const { return kinds_.at(order_.at(index)); }
    std::size_t size() const { return order_.size(); }
    /// Those that differ.
    const std::vector<Shared>& kinds() const { return kinds_; }

  private:
    std::vector<Shared> kinds_;
    std::vector<std::uint32_t> order_;
    std::map<std::string, std::uint32_t> known_;  // by what they say
};

}  // namespace kreisel
