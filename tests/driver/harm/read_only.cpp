// SPDX-License-Identifier: BSD-3-Clause
//
// Results in a folder that may be read only: what writes elsewhere works, and the rest says what it cannot write.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/paths/at_path.hpp"
#include "tests/driver/harm/small_folder.hpp"

namespace kreisel::read_only_tests {

namespace fs = std::filesystem;

/// Takes the rights to write a folder, and as root those of root too, for as long as it lives.
class ReadOnly {
  public:
    explicit ReadOnly(const fs::path& folder) : folder_(folder) {
        fs::permissions(folder_.parent_path(), fs::perms::all);
        set(fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write, fs::perm_options::remove);
        constexpr uid_t nobody = 65534;
        if (was_ == 0) { REQUIRE(::seteuid(nobody) == 0); }
    }
    ~ReadOnly() {
        if (was_ == 0 && ::seteuid(0) != 0) { std::terminate(); }  // nothing after it would be as it should
        set(fs::perms::owner_write, fs::perm_options::add);
    }
    ReadOnly(const ReadOnly&) = delete;
    ReadOnly& operator=(const ReadOnly&) = delete;

  private:
    void set(fs::perms rights, fs::perm_options how) const {
        for (const auto& entry : fs::recursive_directory_iterator(folder_)) { fs::permissions(entry, rights, how); }
        fs::permissions(folder_, rights, how);
    }

    const fs::path folder_;
    const uid_t was_ = ::geteuid();
};

TEST_CASE("a folder that can be read only is drawn from, compared and verified; what would be written is named") {
    const SmallFolder small;
    const std::string folder = small.folder.string(), page = (small.scratch / "page.html").string();
    const ReadOnly read_only(small.folder);
    REQUIRE_THROWS_AS(write_atomically(small.folder / "x", "x"), FileError);
    for (const std::vector<std::string>& words : {std::vector<std::string>{"table", folder, "--table", "errors"},
                                                  {"report", folder, "-o", page},
                                                  {"report", folder, "-o", page},
                                                  {"diff", folder, folder},
                                                  {"verify", folder, "--cells", "1"}}) {
        const auto result = run_program(words);
        CAPTURE(words.front(), result.messages);
        CHECK(result.code == 0);
        CHECK(result.messages.empty());
    }
    const auto table = run_program({"table", folder});
    CHECK(table.code == 3);
    CHECK_THAT(table.out, Catch::Contains("Observed orders"));
    CHECK_THAT(table.messages, Catch::Contains("out/tables: cannot be written: Permission denied; the tables are "));
    const auto plot = run_program({"plot", folder});
    CHECK(plot.code == 3);
    CHECK_THAT(plot.messages, Catch::Contains("out/figures: cannot be written: Permission denied; -o FOLDER"));
    const auto report = run_program({"report", folder});
    CHECK(report.code == 3);
    CHECK_THAT(report.messages, Catch::Contains("out/report.html: cannot be written: Permission denied; -o FILE"));
}

TEST_CASE("several may read a folder at the same time, but not while someone writes to it") {
    const ScratchFolder scratch;
    const fs::path folder = scratch / "out";
    make_folder(folder);
    {
        const FolderLock one = FolderLock::of_reader(folder), other = FolderLock::of_reader(folder);
        CHECK_THROWS_AS(FolderLock(folder, ""), FileError);
    }
    {
        const FolderLock writer(folder, "");
        CHECK_THROWS_AS(FolderLock::of_reader(folder), FileError);
        const ReadOnly read_only(folder);
        CHECK_THROWS_AS(FolderLock::of_reader(folder), FileError);
    }
    fs::remove(folder / ".lock");
    const ReadOnly read_only(folder);
    CHECK_NOTHROW(FolderLock::of_reader(folder));
    CHECK(!is_taken(folder / ".lock"));
}

}  // namespace kreisel::read_only_tests
