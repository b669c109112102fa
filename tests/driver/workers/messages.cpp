// SPDX-License-Identifier: BSD-3-Clause
#include <sys/socket.h>

#include <catch2/catch.hpp>
#include <cstdint>

#include "driver/campaign/workers/message.hpp"

using namespace kreisel;

namespace {

struct SocketPair {
    SocketPair() {
        int ends[2] = {-1, -1};
        REQUIRE(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0);
        mine = Descriptor(ends[0]), other = Descriptor(ends[1]);
    }
    Descriptor mine, other;
};

}  // namespace

TEST_CASE("messages are read as they were sent, however many come at once") {
    const std::string large(150000, 'x');  // longer than what is read at once
    SocketPair sockets;
    for (const std::string& text : {std::string("one"), std::string(), large, std::string("four")}) {
        REQUIRE(send_message(sockets.other, text));
    }
    sockets.other = Descriptor();
    MessageReader reader;
    std::vector<std::string> all;
    CHECK_FALSE(reader.next());
    while (reader.read(sockets.mine)) {
        while (auto text = reader.next()) { all.push_back(std::move(*text)); }
        CHECK_FALSE(reader.is_broken());
    }
    CHECK(all == std::vector<std::string>{"one", "", large, "four"});
}

TEST_CASE("a torn message is none, and what no sender of ours sends is told") {
    SocketPair torn, wild;
    const std::uint64_t ten = 10, endless = ~std::uint64_t(0);
    REQUIRE(::send(torn.other.number(), &ten, sizeof ten, 0) == sizeof ten);
    REQUIRE(::send(torn.other.number(), "nine byte", 9, 0) == 9);
    MessageReader reader;
    CHECK(reader.read(torn.mine));
    CHECK_FALSE(reader.next());
    CHECK_FALSE(reader.is_broken());
    torn.other = Descriptor();
    CHECK_FALSE(reader.read(torn.mine));

    REQUIRE(::send(wild.other.number(), &endless, sizeof endless, 0) == sizeof endless);
    MessageReader of_wild;
    CHECK(of_wild.read(wild.mine));
    CHECK_FALSE(of_wild.next());
    CHECK(of_wild.is_broken());
}
