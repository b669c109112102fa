// SPDX-License-Identifier: BSD-3-Clause
//
// How far a run is, on the terminal or in a log.
#pragma once

#include <chrono>
#include <cstddef>
#include <iosfwd>
#include <string>

namespace kreisel {

struct ProgressState {
    std::size_t done = 0, total = 0, failed = 0;
    std::size_t references_done = 0, references = 0;
    double weight_done = 0, weight_total = 0;  ///< of the cells to be computed, for the estimate of the time left
};

/// As much of a line as a terminal of so many columns holds; 0: their number is not known. `text` is ASCII.
std::string cut_to_terminal(std::string text, unsigned columns);

/// An estimate of the seconds that a run still takes, some time after it has begun: `done` and `total` are its
/// estimated costs, s. Until a fiftieth is done the estimate counts for more than what little was measured.
double seconds_left(double elapsed, double done, double total);

/// On a terminal one line that rewrites itself, or nothing if the terminal cannot (TERM is unset or "dumb"); elsewhere
/// a line every few seconds. Silent for short runs.
class Progress {
  public:
    Progress(std::ostream& out, std::string name, bool terminal);
    void show(const ProgressState& state);
    /// Removes the line that rewrites itself.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;
    std::ostream& out_;
    std::string name_;
    bool terminal_, silent_;
    bool line_open_ = false;
    Clock::time_point start_, last_;
};

}  // namespace kreisel
