// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/verify/recomputer.hpp"

#include <optional>

#include "driver/campaign/cell_run.hpp"
#include "driver/campaign/dispatch/work.hpp"
#include "driver/campaign/workers/bad_end.hpp"
#include "driver/campaign/workers/limits.hpp"
#include "driver/campaign/workers/message.hpp"
#include "records/cell/line.hpp"
#include "records/reference_store.hpp"
#include "records/trajectory_file.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

/// Of the folder, if this code has made it, or a program of the same sources where this one makes none; else computed.
std::optional<Reference> reference_of(const PlannedCell& planned, const Plan& plan, const std::filesystem::path& folder,
                                      const Engines& engines) {
    if (planned.reference().empty()) { return std::nullopt; }
    const PlannedReference& wanted = plan.references.at(planned.reference());
    const std::string digest = engines.reference_digest();
    auto stored = load_reference(reference_file(folder, planned.reference()), wanted,
                                 engines.has_quad() ? digest : digest_of_sources(digest));
    if (stored) { return std::move(stored->reference); }
    if (!engines.has_quad()) { return std::nullopt; }
    return engines.quad().reference(wanted.problem, wanted.parameters, wanted.begin.get(), wanted.t_end, wanted.samples,
                                    {});
}

std::string recomputed(const PlannedCell& planned, const std::optional<Reference>& reference, const Engine& engine,
                       const Printed& printed) {
    const Reference* known = reference ? &*reference : nullptr;
    TrajectorySum samples;
    Outcome outcome = run_cell(planned, engine, known, {}, &samples);
    outcome.detail = with_printed(outcome.detail, printed.take());
    return result_text(record_of_run(planned, outcome, known, samples.sum()));
}

}  // namespace

Recomputer::Recomputer(const Plan& plan, const std::filesystem::path& folder, const Engines& engines)
    : plan_(plan), forker_([&](const Descriptor& socket, const Printed& printed, const Watch&) {
          while (const auto index = receive_message(socket)) {
              const PlannedCell& planned = plan.cells[std::stoul(*index)];
              const auto reference = reference_of(planned, plan, folder, engines);
              printed.take();
              send_message(socket, recomputed(planned, reference, engines.of(planned.precision()), printed));
          }
      }) {}

std::string Recomputer::result(std::size_t index) {
    std::string reason;
    if (!worker_) { worker_ = forker_.spawn(allowed_memory(), reason); }
    if (!worker_) { throw FileError("no worker process can be started: " + reason); }
    send_message(worker_.socket, std::to_string(index));
    if (auto text = receive_message(worker_.socket)) { return *text; }
    const BadEnd end = bad_end(forker_.bury(worker_));
    const std::string detail = with_printed(end.detail, worker_.printed.take());
    worker_ = Worker();
    const Outcome outcome = ended(status::with_reason(status::crashed, end.by), detail);
    return result_text(record_of(plan_.cells[index], outcome, nullptr));
}

}  // namespace kreisel
