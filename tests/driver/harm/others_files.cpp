// SPDX-License-Identifier: BSD-3-Clause
//
// Outputs at paths that the user names: what kreisel has written is written over, what someone else has is not.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "driver/cli/certify/sheet.hpp"
#include "plots/tables/text.hpp"
#include "support/errors.hpp"
#include "tests/driver/harm/small_folder.hpp"

namespace kreisel::others_files_tests {

namespace fs = std::filesystem;

const std::string notes = "my own notes\n";

void put_notes(const fs::path& file) {
    fs::remove_all(file);
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << notes;
}

/// A command that writes `file` and, it may be, others that stand or fall with it.
struct Output {
    std::vector<std::string> words;
    fs::path file;
};

void check_output(const Output& output) {
    const auto run = [&] { return run_program(output.words); };
    CAPTURE(output.file.string());
    put_notes(output.file);
    const auto refused = run();
    CHECK(refused.code == 3);
    CHECK_THAT(refused.messages, Catch::Contains(output.file.string() + ": expected nothing at this name, or what "
                                                                        "kreisel has written, got another file"));
    CHECK(contents(output.file) == notes);
    std::ofstream(output.file).close();  // nothing to lose
    CHECK(run().code < 2);
    const std::string written = contents(output.file);
    CHECK(run().code < 2);
    CHECK(contents(output.file) == written);
    fs::remove(output.file);
    fs::create_directory(output.file);
    CHECK_THAT(run().messages, Catch::Contains("got a folder"));
    fs::remove(output.file);
}

TEST_CASE("files at paths of the user are written over where kreisel has written them, and refused otherwise") {
    const SmallFolder small;
    const std::string folder = small.folder.string(), into = (small.scratch / "into").string();
    check_output({{"report", folder, "-o", (small.scratch / "page.html").string()}, small.scratch / "page.html"});
    check_output({{"diff", folder, folder, "--csv", (small.scratch / "d.csv").string()}, small.scratch / "d.csv"});
    check_output({{"atlas", "-o", into}, fs::path(into) / "atlas.tex"});
    check_output({{"plot", folder, "-o", into}, fs::path(into) / "plotdata" / "small.gp"});
    const auto figure = fs::path(into) / "figures" / "small.svg";
    put_notes(figure);
    CHECK(run_program({"plot", folder, "-o", into}).code == 3);
    CHECK(contents(figure) == notes);
}

TEST_CASE("of files that are written together none is written over where one is someone else's") {
    const ScratchFolder scratch;
    const auto folder = scratch / "into";
    const TextTable table{"eigenvalues", "Eigenvalues", {"a", "b"}, {{"1", "2"}}};
    for (const char* ending : {".csv", ".md", ".tex"}) {
        const auto file = folder / (std::string("eigenvalues") + ending);
        put_notes(file);
        CHECK_THROWS_AS(write_table(folder, table, table), FileError);
        CHECK(contents(file) == notes);
        fs::remove(file);
    }
    write_table(folder, table, table);
    CHECK_NOTHROW(write_table(folder, table, table));
    const DataSheet sheet{"rkmk/rk4: the classical method", {}, {}, {}};
    for (const char* ending : {".txt", ".md", ".tex"}) {
        const auto file = folder / (std::string("rkmk-rk4") + ending);
        put_notes(file);
        CHECK_THROWS_AS(require_own_sheet(folder, "rkmk/rk4"), FileError);
        fs::remove(file);
    }
    write_sheet(folder, "rkmk/rk4", sheet);
    CHECK_NOTHROW(require_own_sheet(folder, "rkmk/rk4"));
}

}  // namespace kreisel::others_files_tests
