// SPDX-License-Identifier: BSD-3-Clause
//
// What a program says to the process that forks its workers, and what that answers. Internal to the workers.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "support/files.hpp"

namespace kreisel {

struct Request {
    enum class Kind { spawn, release, bury, interrupt } kind = Kind::spawn;
    pid_t process = -1;
    std::uint64_t memory = 0;
};

/// Of a spawn the process and its place among those at work, or -1 and errno; of a release or a burial how it ended.
struct Answer {
    pid_t process = -1;
    int status = 0;
    std::size_t place = 0;
};

struct ReceivedAnswer {
    Answer answer;
    std::vector<Descriptor> descriptors;  ///< fewer than were sent if this process can have no more
};

/// Throws FileError if the other process is gone.
void send_request(const Descriptor& control, const Request& request);
ReceivedAnswer receive_answer(const Descriptor& control);

/// Nothing if the program is gone.
std::optional<Request> receive_request(const Descriptor& control);
void send_answer(const Descriptor& control, const Answer& answer, const std::vector<int>& descriptors);

}  // namespace kreisel
