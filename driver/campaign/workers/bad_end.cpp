// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/workers/bad_end.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <csignal>
#include <cstring>

namespace kreisel {

BadEnd bad_end(int status) {
    if (!WIFSIGNALED(status)) {
        const int code = WEXITSTATUS(status);
        return {false, fmt::format("exit {}", code), fmt::format("its process ended itself with exit code {}", code)};
    }
    const int signal = WTERMSIG(status);
    const char *name = ::sigabbrev_np(signal), *meaning = ::sigdescr_np(signal);
    const std::string by = name != nullptr ? fmt::format("SIG{}", name) : fmt::format("signal {}", signal);
    return {signal == SIGPROF, by,
            fmt::format("its process was ended by {} ({})", by, meaning != nullptr ? meaning : "of no name")};
}

}  // namespace kreisel
