// SPDX-License-Identifier: BSD-3-Clause
//
// Computes cells of a results folder again, in a process of their own as a run does, and writes nothing.
#pragma once

#include <filesystem>
#include <string>

#include "driver/campaign/workers/forker.hpp"
#include "driver/plan/plan.hpp"

namespace kreisel {

class Recomputer {
  public:
    /// All outlive it.
    Recomputer(const Plan& plan, const std::filesystem::path& folder, const Engines& engines);

    /// What the result line of a cell should be, without its sum. Throws FileError.
    std::string result(std::size_t index);

  private:
    const Plan& plan_;
    Forker forker_;
    Worker worker_;
};

}  // namespace kreisel
