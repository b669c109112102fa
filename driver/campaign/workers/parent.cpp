// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/workers/parent.hpp"

#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>

namespace kreisel {

void die_with(pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent) { ::_exit(1); }
}

}  // namespace kreisel
