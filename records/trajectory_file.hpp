// SPDX-License-Identifier: BSD-3-Clause
//
// Writes the samples of a cell to disk. A trajectory is a header of `name [unit]`, then one line per sample. While the
// cell runs it grows in a part beside its place, and is moved there when the cell is done: samples taken before a run
// was stopped or killed remain in the part.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/engine.hpp"
#include "records/cell/record.hpp"
#include "support/files.hpp"
#include "support/hash.hpp"

namespace kreisel {

/// The trajectories below an output folder that are not complete, by name.
std::vector<std::filesystem::path> trajectory_parts(const std::filesystem::path& folder);

/// The sum of a trajectory that is there. Throws FileError.
std::string sum_of_trajectory(const std::filesystem::path& file);

/// The sum of a trajectory's text, which is not kept.
class TrajectorySum : public SampleSink {
  public:
    void begin(const std::vector<Column>& columns) override;
    void add(const std::string& row) override;
    /// hash_text of the whole file; empty where there is no sample.
    std::string sum() const { return sampled_ ? hash_text(hash_) : ""; }

  protected:
    /// The next line of the text.
    virtual void take(const std::string& line);

  private:
    std::uint64_t hash_ = hash64("");
    bool sampled_ = false;
};

/// Writes the text to FILE.part: the first sample at once, the others about once a second. A part that is neither kept
/// nor discarded stays. All functions throw FileError. An empty path is that of a cell without samples, of which there
/// is no part.
class TrajectoryFile final : public TrajectorySum {
  public:
    explicit TrajectoryFile(std::filesystem::path file) : file_(std::move(file)) {}
    void add(const std::string& row) override;
    /// Writes pending samples.
    void flush();
    /// Renames the part, now complete, to the file.
    void keep();
    /// Removes the part.
    void discard();

  private:
    void take(const std::string& line) override;
    std::filesystem::path part() const { return file_.string() + ".part"; }

    std::filesystem::path file_;
    std::unique_ptr<LineAppender> stream_;
    std::string pending_;  // whole lines, without the last line's end
    std::chrono::steady_clock::time_point written_ = {};
};

}  // namespace kreisel
