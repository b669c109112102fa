// SPDX-License-Identifier: BSD-3-Clause
//
// Ctrl-C and SIGTERM as a flag that a run checks.
#pragma once

#include <csignal>

namespace kreisel {

/// While it lives, SIGINT and SIGTERM only set the flag, and SIGPIPE and SIGXFSZ are ignored, so that a closed terminal
/// and a file that has become too large cause errors of writing. Signals are often sent twice (by a terminal to the
/// group, then by a shell or a batch system): only one that comes 2 s after the first ends the program at once. After
/// an interrupt that stays so, for the program is about to end. A guard within another one changes nothing.
class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    static bool requested();

  private:
    struct sigaction old_interrupt_ = {}, old_terminate_ = {}, old_pipe_ = {}, old_size_ = {};
};

}  // namespace kreisel
