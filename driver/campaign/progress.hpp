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
    double share = 0;         ///< done of what all is estimated to cost, parts of cells included
    double seconds_left = 0;  ///< estimated
};

/// As much of a line as a terminal of so many columns holds; 0: their number is not known. `text` is ASCII.
std::string cut_to_terminal(std::string text, unsigned columns);

/// On a terminal one line that rewrites itself, or nothing if the terminal cannot (TERM is unset or "dumb"); elsewhere
/// a line every few seconds. Silent for short runs.
class Progress {
  public:
    Progress(std::ostream& out, std::string name, bool terminal);
    /// Whether `show` would show anything.
    bool is_due() const;
    void show(const ProgressState& state);
    /// Removes the line that rewrites itself.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;
    std::ostream& out_;
    std::string name_;
    bool terminal_, silent_;
    bool line_open_ = false;
    Clock::time_point last_ = Clock::now();
};

}  // namespace kreisel
