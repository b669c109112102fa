// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/workers/shares.hpp"

#include <sys/mman.h>

#include <new>

namespace kreisel {

Shares::Shares() {
    void* memory = ::mmap(nullptr, sizeof(Places), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    const bool refused = memory == MAP_FAILED;  // NOLINT(cppcoreguidelines-pro-type-cstyle-cast): the system's macro
    if (!refused) { places_ = new (memory) Places{}; }
}

Shares::~Shares() {
    if (places_ != nullptr) { ::munmap(places_, sizeof(Places)); }
}

}  // namespace kreisel
