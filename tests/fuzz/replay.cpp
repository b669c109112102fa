// SPDX-License-Identifier: BSD-3-Clause
//
// The inputs that fuzzing has kept, because each reaches something that the others do not, or because it once broke a
// reader.
#include <catch2/catch.hpp>
#include <filesystem>

#include "kreisel_build.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/fuzz/readers.hpp"

using namespace kreisel;

namespace {

const std::filesystem::path kept = std::filesystem::path(build::source_dir) / "tests/fuzz/corpus";

}  // namespace

TEST_CASE("every reader takes or refuses what fuzzing has kept", "[fuzz]") {
    for (const auto& [name, read] : readers()) {
        std::size_t taken = 0, refused = 0;
        for (const auto& entry : std::filesystem::directory_iterator(kept / name)) {
            INFO(entry.path().string());
            Reading reading = Reading::refused;
            CHECK_NOTHROW(reading = read(contents(entry.path())));
            ++(reading == Reading::taken ? taken : refused);
        }
        INFO(name << ": " << taken << " taken, " << refused << " refused");
        CHECK(taken >= 1);
        CHECK(refused >= 1);
    }
}

TEST_CASE("the kept inputs are small, and none is of a reader that there is not", "[fuzz]") {
    std::uintmax_t bytes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kept)) {
        if (entry.is_directory()) {
            CHECK(readers().contains(entry.path().filename().string()));
        } else {
            bytes += entry.file_size();
        }
    }
    CHECK(bytes < 300'000);
}
