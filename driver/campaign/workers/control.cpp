// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/workers/control.hpp"

#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "support/errors.hpp"

namespace kreisel {

namespace {

constexpr std::size_t most_descriptors = 2;

using Ancillary = std::array<char, CMSG_SPACE(most_descriptors * sizeof(int))>;

[[noreturn]] void fail() { throw FileError("the process that starts workers has ended"); }

std::vector<Descriptor> descriptors_of(msghdr& message) {
    std::vector<Descriptor> all;
    for (cmsghdr* part = CMSG_FIRSTHDR(&message); part != nullptr; part = CMSG_NXTHDR(&message, part)) {
        const std::size_t count = (part->cmsg_len - CMSG_LEN(0)) / sizeof(int);
        for (std::size_t i = 0; i < count; ++i) {
            int number = -1;
            std::memcpy(&number, CMSG_DATA(part) + i * sizeof number, sizeof number);
            all.emplace_back(number);
        }
    }
    return all;
}

}  // namespace

void send_request(const Descriptor& control, const Request& request) {
    while (::send(control.number(), &request, sizeof request, MSG_NOSIGNAL) < 0) {
        if (errno != EINTR) { fail(); }
    }
}

ReceivedAnswer receive_answer(const Descriptor& control) {
    ReceivedAnswer received;
    alignas(cmsghdr) Ancillary ancillary = {};
    iovec part{&received.answer, sizeof received.answer};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = ancillary.data();
    message.msg_controllen = ancillary.size();
    ssize_t size = -1;
    while ((size = ::recvmsg(control.number(), &message, MSG_CMSG_CLOEXEC)) < 0 && errno == EINTR) {}
    if (size != sizeof received.answer) { fail(); }
    received.descriptors = descriptors_of(message);
    return received;
}

std::optional<Request> receive_request(const Descriptor& control) {
    Request request;
    ssize_t size = -1;
    while ((size = ::recv(control.number(), &request, sizeof request, 0)) < 0 && errno == EINTR) {}
    return size == sizeof request ? std::optional(request) : std::nullopt;
}

void send_answer(const Descriptor& control, const Answer& answer, const std::vector<int>& descriptors) {
    alignas(cmsghdr) Ancillary ancillary = {};
    Answer sent = answer;
    iovec part{&sent, sizeof sent};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    if (!descriptors.empty()) {
        message.msg_control = ancillary.data();
        message.msg_controllen = CMSG_SPACE(descriptors.size() * sizeof(int));
        cmsghdr* header = CMSG_FIRSTHDR(&message);
        header->cmsg_level = SOL_SOCKET;
        header->cmsg_type = SCM_RIGHTS;
        header->cmsg_len = CMSG_LEN(descriptors.size() * sizeof(int));
        std::memcpy(CMSG_DATA(header), descriptors.data(), descriptors.size() * sizeof(int));
    }
    while (::sendmsg(control.number(), &message, MSG_NOSIGNAL) < 0 && errno == EINTR) {}
}

}  // namespace kreisel
