// SPDX-License-Identifier: BSD-3-Clause
//
// Messages between processes: a length and as many bytes, over a stream socket.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "support/files.hpp"

namespace kreisel {

/// False if the other end is gone.
bool send_message(const Descriptor& socket, std::string_view text);

/// Waits for the next message; nothing if the other end is gone, even in the middle of one.
std::optional<std::string> receive_message(const Descriptor& socket);

}  // namespace kreisel
