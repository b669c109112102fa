// SPDX-License-Identifier: BSD-3-Clause
//
// Which program on which machine produced a result.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace kreisel {

/// Identifies what numbers depend on: a hash of the running program itself, so that a changed source, compiler, flag or
/// statically linked library gives another one, also from an uncommitted tree; of the build ids of the numerical
/// libraries it has loaded; and of the instruction level they run at.
std::string build_id();

/// Whether the system tells about its processes, which is /proc: an empty root has none.
bool has_proc();
/// The file of this program; without /proc the one by which it was started.
std::filesystem::path program_file();

/// Library names and versions the program was compiled with, and the C library it runs on.
std::vector<std::pair<std::string, std::string>> library_versions();

/// "model name" of /proc/cpuinfo; empty where there is none.
std::string cpu_model();

/// Now, UTC, as 2026-01-31T12:00:00Z.
std::string utc_now();

}  // namespace kreisel
