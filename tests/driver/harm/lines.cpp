// SPDX-License-Identifier: BSD-3-Clause
//
// Lines that stand where their run has not written them, each with the sum that it should have.
#include <catch2/catch.hpp>

#include "records/diff/recorded_folder.hpp"
#include "records/reading/read_results.hpp"
#include "support/files.hpp"
#include "tests/driver/harm/small_folder.hpp"

using namespace kreisel;

namespace {

void check_each_reader(const std::string& folder, const std::string& fault) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{"table", folder},
                                                  {"report", folder},
                                                  {"verify", folder, "--cells", "0"},
                                                  {"diff", folder, folder}}) {
        const auto result = run_program(words);
        CAPTURE(words.front(), result.messages);
        CHECK(result.code == 3);
        CHECK_THAT(result.messages, Catch::Contains(fault));
    }
}

}  // namespace

TEST_CASE("a cell that has two lines in results.jsonl is named with its line, and counts once") {
    const SmallFolder small;
    const auto file = small.folder / "results.jsonl";
    const std::string text = contents(file), folder = small.folder.string();
    REQUIRE(run_program({"table", folder}).code == 0);
    const std::string first = text.substr(0, text.find('\n') + 1);
    put(file, text + first);
    check_each_reader(folder, "results.jsonl:3: not a result line: damaged: an earlier line");
    CHECK(read_results(small.folder).rows.size() == 2);
    CHECK(read_recorded_folder(small.folder).cells.size() == 2);
}

TEST_CASE("lines of results.jsonl in another order are noticed, though each has its sum") {
    const SmallFolder small;
    const auto file = small.folder / "results.jsonl";
    const std::string text = contents(file), folder = small.folder.string();
    const std::size_t second = text.find('\n') + 1;
    put(file, text.substr(second) + text.substr(0, second));
    check_each_reader(folder, "results.jsonl: damaged: it is not what sums.sha256 says");
    CHECK(read_results(small.folder).rows.size() == 2);
    REQUIRE(run_program({"run", small.config, "-o", folder, "--resume"}).code == 0);
    CHECK(contents(file) == text);
    CHECK(run_program({"verify", folder, "--cells", "0"}).code == 0);
}

TEST_CASE("what a journal has more than its run has written, or has in place of its last line, is noticed") {
    const SmallFolder small;
    const auto file = small.folder / "journal.jsonl";
    const std::string text = contents(file), first = text.substr(0, text.find('\n') + 1);
    const std::pair<std::string, std::string> changed[] = {{text + first, "something has been added"},
                                                           {text + "torn", "something has been added"},
                                                           {std::string(text.size(), '\0'), "its last line is torn"},
                                                           {first, "its end is missing"}};
    for (const auto& [damaged, fault] : changed) {
        put(file, damaged);
        for (const std::vector<std::string>& words :
             {std::vector<std::string>{"table", small.folder.string()},
              {"merge", small.folder.string(), "-o", (small.scratch / "merged").string()}}) {
            const auto result = run_program(words);
            CAPTURE(words.front(), result.messages);
            CHECK(result.code == 3);
            CHECK_THAT(result.messages, Catch::Contains("journal.jsonl:") && Catch::Contains(fault));
        }
    }
    put(file, text);
    CHECK(run_program({"table", small.folder.string()}).code == 0);
}
