// SPDX-License-Identifier: BSD-3-Clause
//
// What a run keeps of its finished cells, and the files from which it reads the rest.
#include <fmt/format.h>
#include <malloc.h>

#include <catch2/catch.hpp>

#include "driver/campaign/dispatch/job.hpp"
#include "driver/campaign/finished.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/sha256.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;

namespace finished_cells {

namespace {

CellRecord record_with(const std::string& status, const std::string& label) {
    CellRecord record;
    record.identity.cell = "00000000000000ab";
    record.identity.problem = "heavy_top";
    record.identity.label = label;
    record.outcome.status = status;
    return record;
}

std::size_t bytes_in_use() { return ::mallinfo2().uordblks; }

}  // namespace

TEST_CASE("a finished cell takes at most forty bytes, and says all from its journal", "[finished]") {
    const ScratchFolder scratch;
    LineAppender journal(scratch / "journal.jsonl");
    const std::string long_label(5000, 'x');
    const std::size_t count = 1000, before = bytes_in_use();
    FinishedCells finished(count);
    const std::uint32_t number = finished.add_journal(scratch / "journal.jsonl");
    for (std::size_t i = 0; i < count; ++i) {
        const CellRecord record = record_with(i % 2 == 0 ? "ok" : "left_chart", fmt::format("{} {}", i, long_label));
        const std::string line = journal_line(record, "b");
        finished.set(i, ending_of(record.outcome),
                     {number, static_cast<std::uint32_t>(line.size()), journal.append(line)});
    }
    CHECK(bytes_in_use() - before < 40 * count);
    CHECK(finished.size() == count);
    CHECK(finished.record(640).identity.label == "640 " + long_label);
    CHECK(finished.end(640) == CellEnd::ok);
    CHECK(finished.end(641) == CellEnd::failed);
}

TEST_CASE("of several lines of a cell the last counts, and what was changed behind our back is refused", "[finished]") {
    const ScratchFolder scratch;
    const std::string first = journal_line(record_with("ok", "first"), "b");
    const std::string second = journal_line(record_with("skipped", "second"), "b");
    const std::string file = scratch.file("journal.jsonl", first + "\n" + second + "\n");
    const auto size = [](const std::string& line) { return static_cast<std::uint32_t>(line.size()); };
    FinishedCells finished(2);
    const std::uint32_t number = finished.add_journal(file);
    CHECK_FALSE(finished.has(1));
    finished.set(1, ending_of(record_with("ok", "first").outcome), {number, size(first), 0});
    finished.set(1, ending_of(record_with("skipped", "second").outcome), {number, size(second), first.size() + 1});
    CHECK(finished.size() == 1);
    CHECK(finished.end(0) == CellEnd::missing);
    CHECK(finished.end(1) == CellEnd::skipped);
    CHECK(finished.record(1).identity.label == "second");
    finished.set(1, ending_of(record_with("ok", "first").outcome), {number, size(first) - 1, 0});
    CHECK_THROWS_WITH(finished.record(1), Catch::Contains(file + ": has changed"));
    CHECK_THROWS_WITH(finished.line(1), Catch::Contains(file + ": has changed"));
    finished.set(1, ending_of(record_with("ok", "first").outcome), {number, size(first), first.size() + second.size()});
    CHECK_THROWS_AS(finished.record(1), FileError);
}

TEST_CASE("what a worker says of a cell is read back, and what is none says nothing", "[finished]") {
    CellOutcome ok, lost, late, failed;
    ok.status = lost.status = late.status = "ok";
    failed.status = "left_chart";
    lost.lost = LostIntegral{"energy", 0.5};
    late.reference = ReferenceNote{{}, 1, true};
    for (const CellOutcome& outcome : {ok, lost, late, failed}) {
        const CellEnding ending = ending_of(outcome), again = ending_in(record_text(ending, "line"));
        CHECK(again.end == (outcome.status == "ok" ? CellEnd::ok : CellEnd::failed));
        CHECK(again.end == ending.end);
        CHECK(again.remarkable == (outcome.lost || outcome.reference));
        CHECK(line_in(record_text(ending, "line")) == "line");
    }
    for (const char* text : {"", "o", "x.line", "{}"}) { CHECK(ending_in(text).end == CellEnd::missing); }
    CHECK(line_in("o").empty());
}

TEST_CASE("lines are visited with their places, and a torn one is told", "[finished]") {
    const ScratchFolder scratch;
    const auto visited = [&](const std::string& text) {
        std::string all;
        const bool whole = for_each_line(scratch.file("f", text), [&](std::uint64_t begin, const std::string& line) {
            all += fmt::format("{}:{};", begin, line);
        });
        return all + (whole ? "" : "torn");
    };
    CHECK(visited("") == "");
    CHECK(visited("a\n\nbc\n") == "0:a;2:;3:bc;");
    CHECK(visited("a\nbc") == "0:a;torn");
    CHECK_THROWS_AS(for_each_line(scratch / "", [](std::uint64_t, const std::string&) {}), FileError);
}

TEST_CASE("a file in pieces has the sum of the whole, and is absent until it is kept", "[finished]") {
    const ScratchFolder scratch;
    const std::string piece(10000, 'p');
    std::string all;
    {
        AtomicFile file(scratch / "f");
        for (int i = 0; i < 20; ++i) {
            file.add(piece);
            all += piece;
        }
        CHECK_FALSE(std::filesystem::exists(scratch / "f"));
        file.keep();
    }
    CHECK(contents(scratch / "f") == all);
    CHECK(sha256_of_file(scratch / "f") == sha256_text(all));
    { AtomicFile(scratch / "g").add(all); }
    CHECK(std::distance(std::filesystem::directory_iterator(scratch / ""), {}) == 1);
}

}  // namespace finished_cells
