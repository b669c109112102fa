// SPDX-License-Identifier: BSD-3-Clause
//
// File systems that know no locks, which a flock of this program's own plays.
#include <sys/file.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cerrno>

#include "tests/driver/command_line.hpp"

namespace {

int lock_error = 0;

}  // namespace

extern "C" int flock(int descriptor, int operation) noexcept {
    if (lock_error == 0) { return static_cast<int>(::syscall(SYS_flock, descriptor, operation)); }
    errno = lock_error;
    return -1;
}

using namespace kreisel;

TEST_CASE("a file system without locks is an error that names the remedy") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", good_config());
    for (const int error : {ENOLCK, ENOSYS, EOPNOTSUPP}) {
        lock_error = error;
        const auto result = run_program({"run", config, "-o", (scratch / "out").string()});
        lock_error = 0;
        CHECK(result.code == 3);
        CHECK(result.messages.find((scratch / "out").string() + ": this file system has no locks") == 0);
        CHECK(result.messages.find("Lustre: with flock") != std::string::npos);
        CHECK_FALSE(std::filesystem::exists(scratch / "out" / "manifest.json"));
    }
    CHECK(run_program({"run", config, "-o", (scratch / "out").string()}).code == 0);
}
