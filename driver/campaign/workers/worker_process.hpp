// SPDX-License-Identifier: BSD-3-Clause
//
// How a process becomes a worker. Internal to the workers.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <initializer_list>

#include "driver/campaign/workers/forker.hpp"

namespace kreisel {

void ignore_signals(std::initializer_list<int> signals);

/// What a worker is given.
struct WorkerGoods {
    std::uint64_t memory = 0;  ///< bytes of data
    Share* told = nullptr;     ///< where it tells how far it is
};

/// Sets descriptors, signals and limits, works, and ends the process.
[[noreturn]] void be_worker(pid_t parent, const Descriptor& socket, const Printed& printed, const WorkerGoods& goods,
                            const WorkerMain& work);

}  // namespace kreisel
