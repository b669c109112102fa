// SPDX-License-Identifier: BSD-3-Clause
//
// Limits of this process and of the machine.
#pragma once

#include <cstdint>

namespace kreisel {

/// Bytes that the machine has, or fewer if a cgroup of this process allows fewer.
std::uint64_t allowed_memory();

/// Lets this process have so many bytes of data beyond what it has now, which it shares with its parent; then malloc
/// fails.
void limit_memory(std::uint64_t bytes);

/// While it lives, this process may take so many seconds of CPU time (0: any) and is then ended by SIGPROF.
class CpuLimit {
  public:
    explicit CpuLimit(double seconds);
    ~CpuLimit();
    CpuLimit(const CpuLimit&) = delete;
    CpuLimit& operator=(const CpuLimit&) = delete;

  private:
    bool set_;
};

}  // namespace kreisel
