// SPDX-License-Identifier: BSD-3-Clause
//
// What a worker does: compute references and cells, and their samples. It has the plan by being forked and sees only
// messages; journal and results are written by the program. Internal to the campaign.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "driver/campaign/campaign.hpp"
#include "driver/campaign/dispatch/job.hpp"
#include "driver/campaign/workers/printed.hpp"
#include "records/reference_store.hpp"
#include "records/trajectory_file.hpp"

namespace kreisel {

/// " and printed: ..." after what there is to say; nothing where nothing was printed.
std::string with_printed(const std::string& detail, const std::string& printed);

class WorkerTasks {
  public:
    WorkerTasks(const Plan& plan, const Engines& engines, std::filesystem::path folder, const RunSettings& settings)
        : plan_(plan),
          engines_(engines),
          folder_(std::move(folder)),
          build_(settings.build),
          timeout_(settings.timeout),
          store_(folder_, settings.cache, engines.reference_digest(), settings.references) {}

    /// Answers jobs until the socket is closed. The watch is told how many answers were given, the part of the next one
    /// included.
    void serve(const Descriptor& socket, const Printed& printed, const Watch& watch);

  private:
    std::string answer_reference(const std::string& hash, const Printed& printed, const Watch& watch) const;
    /// While it is locked: computes it and writes it down.
    std::string compute_reference(const PlannedReference& planned, const Printed& printed, const Watch& watch) const;
    std::string answer_cell(const PlannedCell& planned, const Printed& printed, const Watch& watch);
    std::string answer_round(const PlannedCell& planned, const Watch& watch) const;
    /// Of a cell that has run; the samples are put in their place or removed.
    std::string answer_outcome(const PlannedCell& planned, const Outcome& outcome, const Reference* reference,
                               TrajectoryFile& samples) const;
    std::string answer_part(const PlannedCell& planned, TrajectoryFile& samples) const;
    const Reference* reference_of(const PlannedCell& planned);

    const Plan& plan_;
    const Engines& engines_;
    const std::filesystem::path folder_;
    const std::string build_;
    const double timeout_;
    const ReferenceStore store_;
    std::map<std::string, Reference> references_;
};

}  // namespace kreisel
