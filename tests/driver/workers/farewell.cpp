// SPDX-License-Identifier: BSD-3-Clause
//
// Workers that have nothing left to do come to their own end: what a profiler or a count of coverage writes then is
// not lost.
#include <catch2/catch.hpp>
#include <chrono>

#include "driver/campaign/workers/forker.hpp"
#include "driver/campaign/workers/message.hpp"
#include "tests/driver/workers/program_process.hpp"
#include "tests/driver/workers/shared_count.hpp"

using namespace kreisel;

namespace {

void read_all(const Descriptor& socket) {
    while (receive_message(socket)) {}
}

}  // namespace

TEST_CASE("a worker that is released comes to its own end first") {
    SharedCount ends;
    const Forker forker([&](const Descriptor& socket, const Printed&, const Watch&) {
        read_all(socket);
        pause_for(0.1);  // long enough that a kill would come first
        ++ends;
    });
    std::string reason;
    for (int i = 1; i <= 3; ++i) {
        Worker worker = forker.spawn(1U << 30U, reason);
        REQUIRE(worker);
        forker.release(worker);
        CHECK(ends == i);
    }
}

TEST_CASE("a worker that does not end when it is released is killed") {
    const Forker forker([&](const Descriptor& socket, const Printed&, const Watch&) {
        read_all(socket);
        pause_for(1000);
    });
    std::string reason;
    Worker worker = forker.spawn(1U << 30U, reason);
    REQUIRE(worker);
    const auto start = std::chrono::steady_clock::now();
    forker.release(worker);
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(60));
    CHECK(::kill(worker.process, 0) == -1);
}
