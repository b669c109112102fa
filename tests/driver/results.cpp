// SPDX-License-Identifier: BSD-3-Clause
//
// Result lines, journals and tables.
#include <catch2/catch.hpp>
#include <fstream>
#include <limits>

#include "driver/plan/plan.hpp"
#include "records/cell_line.hpp"
#include "records/csv.hpp"
#include "records/journal.hpp"
#include "records/json/strict.hpp"
#include "records/reference_store.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/hash.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;

namespace {

Plan small_plan(const std::string& precision) {
    return plan_of(parse_document("t", R"({"name": "n", "kind": "convergence", "precision": ")" + precision + R"(",
        "problems": [{"name": "heavy_top", "label": "a,\"status\":\"ok\" b"}], "methods": ["rkmk/rk4", "rkmk/midpoint"],
        "time": {"end": 1, "steps": 4}})"),
                   one_engine);
}

FinishedCell finished(const PlannedCell& planned) {
    const Reference reference =
        plain_engine.reference(planned.cell.problem, planned.cell.parameters, planned.cell.t_end, {});
    return finished_cell(planned, plain_engine.run(planned.cell, &reference, {}), &reference);
}

}  // namespace

TEST_CASE("a result line holds what the contract says") {
    const Plan plan = small_plan("double");
    const auto line = nlohmann::json::parse(finished(plan.cells[0]).line);
    for (const char* key : {"cell", "problem", "label", "parameters", "formulation", "method", "options", "projection",
                            "precision", "steps", "h", "t_end", "status", "final", "metrics", "reference", "cost"}) {
        INFO(key);
        CHECK(line.contains(key));
    }
    CHECK(line["h"] == 0.25);
    CHECK(line["final"]["bodies"][0]["R"][2][2] == 1);
    CHECK(line["final"]["multipliers"][0] == 1.0 / 3);
    CHECK(line["metrics"]["error.position"] == 1.0 / 256);
    CHECK(line["reference"]["error"]["error.position"] == 1e-20);
    CHECK_FALSE(line["cost"].contains("cpu_s"));
    const auto journal = nlohmann::json::parse(journal_line(finished(plan.cells[0]), "b"));
    CHECK(journal["cost"]["cpu_s"].get<double>() > 0);
    CHECK(journal["build"] == "b");
}

TEST_CASE("quad numbers are written as decimal strings") {
    const auto line = nlohmann::json::parse(finished(small_plan("quad").cells[0]).line);
    CHECK(line["final"]["multipliers"][1] == "-1e-30");
    CHECK(line["metrics"]["error.position"].is_string());
}

TEST_CASE("a number that is not finite is never written") {
    const PlannedCell planned = small_plan("double").cells[0];
    Outcome outcome = plain_engine.run(planned.cell, nullptr, {});
    outcome.metrics.emplace_back("defect.position", Number{std::numeric_limits<double>::quiet_NaN(), "nan"});
    CHECK_THROWS_AS(finished_cell(planned, outcome, nullptr), std::logic_error);
}

TEST_CASE("a journal line comes back as the result line it was made from") {
    const PlannedCell planned = small_plan("double").cells[0];
    const FinishedCell cell = finished(planned);
    const auto again = read_journal_line(journal_line(cell, "build"), "build");
    REQUIRE(again);
    CHECK(again->line == cell.line);
    CHECK(again->hash == cell.hash);
    CHECK(relabelled(again->line, planned) == cell.line);
    CHECK_FALSE(read_journal_line(journal_line(cell, "build"), "another build"));
    CHECK(journalled_cell(journal_line(cell, "another build")) == cell.hash);
}

TEST_CASE("a journal line that is cut or changed anywhere is not believed") {
    const std::string line = journal_line(finished(small_plan("double").cells[0]), "build");
    for (std::size_t i = 0; i < line.size(); ++i) {
        CHECK_FALSE(read_journal_line(line.substr(0, i), "build"));
        CHECK_FALSE(journalled_cell(line.substr(0, i)));
        std::string flipped = line;
        flipped[i] = static_cast<char>(flipped[i] ^ 1);
        CHECK_FALSE(read_journal_line(flipped, "build"));
        CHECK_FALSE(journalled_cell(flipped));
    }
}

TEST_CASE("a torn journal keeps its good lines and says what it left out") {
    const ScratchFolder scratch;
    const Plan plan = small_plan("double");
    const std::string first = journal_line(finished(plan.cells[0]), "b"),
                      second = journal_line(finished(plan.cells[1]), "b");
    scratch.file("journal.jsonl", first + "\nrubbish\n" + second.substr(0, 100));
    const JournalContents contents_read = read_journals(scratch / "", "b");
    CHECK(contents_read.cells.size() == 1);
    REQUIRE(contents_read.complaints.size() == 2);
    CHECK(contents_read.complaints[0].find("journal.jsonl:2:") != std::string::npos);
    CHECK(contents_read.complaints[1].find("torn last line") != std::string::npos);
    mend_journal(scratch / "journal.jsonl");
    CHECK(contents(scratch / "journal.jsonl") == first + "\nrubbish\n");
}

TEST_CASE("cells of other builds are distinguished from damage, and removed when a journal is pruned") {
    const ScratchFolder scratch;
    const Plan plan = small_plan("double");
    const FinishedCell first = finished(plan.cells[0]), second = finished(plan.cells[1]);
    const std::string mine = journal_line(first, "b") + "\n";
    scratch.file("journal.jsonl",
                 journal_line(first, "a") + "\n" + mine + "rubbish\n" + journal_line(second, "a") + "\n");
    const JournalContents contents_read = read_journals(scratch / "", "b");
    CHECK(contents_read.cells.size() == 1);
    CHECK(contents_read.foreign == std::set<std::string>{second.hash});
    CHECK(contents_read.complaints.size() == 1);
    prune_journal(scratch / "journal.jsonl", "b");
    CHECK(contents(scratch / "journal.jsonl") == mine);
}

TEST_CASE("the table has one column for each option and metric, and quotes what it must") {
    const std::string table = results_table(
        {R"({"cell":"1","label":"a,\"b\"","options":{"q":2},"status":"ok","metrics":{"m":1e-05},"final":{"t":1}})",
         R"({"cell":"2","label":"c","options":{"w":"x"},"status":"ok","metrics":{"n":"0.30000000000000000000001"}})"});
    CHECK(table ==
          "cell,label,status,options.q,options.w,m,n\n1,\"a,\"\"b\"\"\",ok,2,,1e-05,\n2,c,ok,,x,,0."
          "30000000000000000000001\n");
}

TEST_CASE("references are read back as they were stored, and only for the same content and code") {
    const ScratchFolder scratch;
    const Plan plan = small_plan("double");
    PlannedReference planned = plan.references.begin()->second;
    const Reference reference = plain_engine.reference("heavy_top", planned.parameters, planned.t_end, {});
    const auto file = scratch / "r.json";
    const std::string text = stored_reference(planned, reference, "b").text;
    scratch.file("r.json", text);
    const auto stored = load_reference(file, planned, "b");
    REQUIRE(stored);
    CHECK(stored->text == text);
    const Reference& again = stored->reference;
    CHECK(again.state.bodies[0].x[1].text == reference.state.bodies[0].x[1].text);
    CHECK(again.state.bodies[0].x[1].value == reference.state.bodies[0].x[1].value);
    CHECK(again.state.multipliers.size() == 3);
    CHECK(again.error.at("error.position").text == "1e-20");
    CHECK(again.horizon == 50);
    CHECK(again.route == "fake");
    const auto json = nlohmann::json::parse(text);
    for (const char* key : {"version", "commit", "compiler", "computed"}) { CHECK(json["program"][key].is_string()); }
    CHECK_FALSE(load_reference(file, planned, "c"));
    CHECK(load_reference(file, planned, ""));
    CHECK_FALSE(load_reference(scratch / "absent", planned, "b"));
    planned.content = "{}";
    CHECK_FALSE(load_reference(file, planned, "b"));
    for (std::size_t i = 0; i < text.size(); i += 7) {
        scratch.file("r.json", text.substr(0, i));
        CHECK_FALSE(load_reference(file, plan.references.begin()->second, "b"));
        std::string flipped = text;
        flipped[i] = static_cast<char>(flipped[i] ^ 1);
        scratch.file("r.json", flipped);
        CHECK_FALSE(load_reference(file, plan.references.begin()->second, ""));
    }
    const std::string other = R"({"of":{},"format":7)";
    scratch.file("r.json", other + R"(,"sum":")" + hash_text(other) + "\"}\n");
    CHECK_FALSE(load_reference(file, plan.references.begin()->second, ""));
}

TEST_CASE("files are whole or absent, and a folder has one writer") {
    const ScratchFolder scratch;
    write_atomically(scratch / "f", "text");
    CHECK(contents(scratch / "f") == "text");
    for (const auto& entry : std::filesystem::directory_iterator(scratch / "")) {
        CHECK(entry.path().filename() == "f");
    }
    CHECK_THROWS_AS(write_atomically(scratch / "no" / "f", "text"), FileError);
    CHECK_THROWS_AS(LineAppender("/dev/full").append("line"), FileError);
    const FolderLock shard(scratch / "", "1-of-2");
    CHECK_NOTHROW(FolderLock(scratch / "", "2-of-2"));
    CHECK_THROWS_AS(FolderLock(scratch / "", "1-of-2"), FileError);
    CHECK_THROWS_AS(FolderLock(scratch / "", ""), FileError);
}
