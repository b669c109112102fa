// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/workers/message.hpp"

#include <sys/socket.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <utility>

namespace kreisel {

namespace {

using Length = std::uint64_t;
constexpr Length longest = Length(1) << 32U;  // what is longer was not sent by a worker of ours

bool receive_all(int socket, char* bytes, std::size_t count) {
    while (count > 0) {
        const ssize_t received = ::recv(socket, bytes, count, 0);
        if (received < 0 && errno == EINTR) { continue; }
        if (received <= 0) { return false; }
        bytes += received;
        count -= static_cast<std::size_t>(received);
    }
    return true;
}

}  // namespace

bool send_message(const Descriptor& socket, std::string_view text) {
    const Length length = text.size();
    std::string bytes(sizeof length, '\0');
    std::memcpy(bytes.data(), &length, sizeof length);
    bytes += text;
    for (std::string_view rest = bytes; !rest.empty();) {
        const ssize_t sent = ::send(socket.number(), rest.data(), rest.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) { continue; }
        if (sent < 0) { return false; }
        rest.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
}

std::optional<std::string> receive_message(const Descriptor& socket) {
    Length length = 0;
    char header[sizeof length] = {};
    if (!receive_all(socket.number(), header, sizeof length)) { return std::nullopt; }
    std::memcpy(&length, header, sizeof length);
    if (length > longest) { return std::nullopt; }
    std::string text(length, '\0');
    return receive_all(socket.number(), text.data(), text.size()) ? std::optional(std::move(text)) : std::nullopt;
}

bool MessageReader::read(const Descriptor& socket) {
    ssize_t received = -1;
    do { received = ::recv(socket.number(), piece_.data(), piece_.size(), 0); } while (received < 0 && errno == EINTR);
    if (received <= 0) { return false; }
    bytes_.erase(0, std::exchange(taken_, 0));
    bytes_.append(piece_.data(), static_cast<std::size_t>(received));
    return true;
}

std::optional<std::string> MessageReader::next() {
    Length length = 0;
    const std::size_t left = bytes_.size() - taken_;
    if (left < sizeof length) { return std::nullopt; }
    std::memcpy(&length, bytes_.data() + taken_, sizeof length);
    broken_ = length > longest;
    if (broken_ || left - sizeof length < length) { return std::nullopt; }
    const std::size_t begin = std::exchange(taken_, taken_ + sizeof length + length) + sizeof length;
    return bytes_.substr(begin, length);
}

}  // namespace kreisel
