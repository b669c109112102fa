// SPDX-License-Identifier: BSD-3-Clause
//
// Exit codes and the exceptions that cause them.
#pragma once

#include <stdexcept>

namespace kreisel {

/// What the program returns to the shell.
enum class Exit : int { ok = 0, cells_failed = 1, usage = 2, io = 3, internal = 4, interrupted = 130 };

/// A config or a command line that cannot be carried out; nothing was run. The text is ready to print.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A file or folder that cannot be read, written or locked.
struct FileError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace kreisel
