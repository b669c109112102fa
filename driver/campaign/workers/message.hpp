// SPDX-License-Identifier: BSD-3-Clause
//
// Messages between processes: a length and as many bytes, over a stream socket.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "support/files.hpp"

namespace kreisel {

/// False if the other end is gone.
bool send_message(const Descriptor& socket, std::string_view text);

/// Waits for the next message; nothing if the other end is gone, even in the middle of one.
std::optional<std::string> receive_message(const Descriptor& socket);

/// Messages of a sender that does not wait for answers, as many at once as have come.
class MessageReader {
  public:
    /// Waits until something has come, if nothing has; false if the other end is gone.
    bool read(const Descriptor& socket);
    /// The next of the messages that have come; nothing if none is whole.
    std::optional<std::string> next();
    /// Whether what came next was not sent by send_message.
    bool is_broken() const { return broken_; }

  private:
    std::vector<char> piece_ = std::vector<char>(std::size_t(1) << 16U);
    std::string bytes_;      // that have come
    std::size_t taken_ = 0;  // of them
    bool broken_ = false;
};

}  // namespace kreisel
