// SPDX-License-Identifier: BSD-3-Clause
//
// Ctrl-C and SIGTERM as a flag that a run checks.
#pragma once

#include <csignal>

namespace kreisel {

/// While it lives, SIGINT and SIGTERM only set the flag, and SIGPIPE is ignored, so that a closed terminal causes an
/// error of writing. A second signal ends the program at once.
class InterruptGuard {
  public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;
    static bool requested();

  private:
    struct sigaction old_interrupt_ = {}, old_terminate_ = {}, old_pipe_ = {};
};

}  // namespace kreisel
