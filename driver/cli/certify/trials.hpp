// SPDX-License-Identifier: BSD-3-Clause
//
// The experiments behind the data sheet of a method: shipped configs (experiments/certificates/) with this method in
// place of theirs.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "driver/plan/plan.hpp"
#include "records/results.hpp"

namespace kreisel {

/// A folder that is removed with this object.
class TemporaryFolder {
  public:
    /// Throws FileError if it cannot be made.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

/// Thrown where a user stops a trial.
struct TrialInterrupted {};

/// Runs a plan into a folder, references from the cache. Throws TrialInterrupted.
void run_plan(const Plan& plan, const std::filesystem::path& folder, const Engines& engines, std::ostream& messages);

/// Runs the shipped config `name` with one method into folder/name and reads its results. Where the config
/// has no precision, it runs in quad above order 4, so that errors fall far enough for an order; a method with a step
/// control of its own runs to tolerances.
/// With `times` above 1 runs are that many times as long, in as many more steps; their config lists its counts.
/// References are those of the cache. Throws UsageError if the config cannot be read, TrialInterrupted.
Results run_trial(const std::string& name, const MethodDescription& method, int times,
                  const std::filesystem::path& folder, const Engines& engines, std::ostream& messages);

}  // namespace kreisel
