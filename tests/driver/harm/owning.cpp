// SPDX-License-Identifier: BSD-3-Clause
//
// What kreisel writes over and removes in a results folder, and what it leaves alone.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "records/cell/line.hpp"
#include "records/folder/owned_files.hpp"
#include "records/journal.hpp"
#include "records/manifest.hpp"
#include "records/provenance.hpp"
#include "records/sums/sum_list.hpp"
#include "records/trajectory_file.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;

namespace {

/// A run with samples, and commands on its folder.
struct OwnedFolder {
    ScratchFolder scratch;
    std::string config = scratch.file("own.json", R"({"name": "own", "kind": "convergence", "problems": ["heavy_top"],
        "methods": ["rkmk/rk4"], "time": {"end": 1, "steps": [2, 4]}, "output": {"samples": 2}})");
    std::filesystem::path folder = scratch / "out";

    ProgramResult run(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> words = {"run", config, "-o", folder.string()};
        words.insert(words.end(), more.begin(), more.end());
        return run_program(words);
    }
    void write(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((folder / name).parent_path());
        std::ofstream(folder / name) << text;
    }
    nlohmann::ordered_json manifest() const {
        return nlohmann::ordered_json::parse(contents(folder / "manifest.json"));
    }
};

bool any_cell(const std::string& /*cell*/) { return true; }

const std::vector<std::string> foreign_names = {"results_2024.csv", "notes.txt",         "submit.sh",
                                                "journal.txt",      "manifest_old.json", "tables/mine.md",
                                                "figures/mine.png", "journal2.jsonl",    "trajectories/mine.csv"};

}  // namespace

TEST_CASE("files of someone else stay as they are, whatever is run, resumed, overwritten or tabulated") {
    const OwnedFolder own;
    for (const std::string& name : foreign_names) { own.write(name, "not kreisel's: " + name); }
    CHECK(own.run().code == 0);
    CHECK(own.run({"--resume"}).code == 0);
    CHECK(own.run({"--overwrite"}).code == 0);
    CHECK(run_program({"table", own.folder.string()}).code == 0);
    CHECK(run_program({"table", own.folder.string()}).code == 0);
    for (const std::string& name : foreign_names) { CHECK(contents(own.folder / name) == "not kreisel's: " + name); }
}

TEST_CASE("a file at a name that a run would write is refused if no manifest lists it") {
    for (const char* name : {"results.csv", "results.jsonl", "journal.jsonl", "manifest.json", "sums.sha256"}) {
        const OwnedFolder own;
        own.write(name, "[]");
        for (const std::vector<std::string>& flags : {std::vector<std::string>{}, {"--overwrite"}}) {
            const auto result = own.run(flags);
            CAPTURE(name, flags.size(), result.messages);
            CHECK(result.code == 2);
            CHECK_THAT(result.messages,
                       Catch::Contains(std::string("out/") + name + ": expected nothing at this name"));
            CHECK(contents(own.folder / name) == "[]");
        }
    }
    const OwnedFolder own;
    REQUIRE(own.run().code == 0);
    std::filesystem::remove(own.folder / "manifest.json");
    CHECK(own.run({"--overwrite"}).code == 2);
    CHECK(own.run({"--resume"}).code == 0);  // lines of the journal have sums: it is one of ours
}

TEST_CASE("a folder that has lost its journal still holds results") {
    const OwnedFolder own;
    REQUIRE(own.run().code == 0);
    std::filesystem::remove(own.folder / "journal.jsonl");
    const std::string results = contents(own.folder / "results.jsonl");
    const auto again = own.run();
    CHECK(again.code == 2);
    CHECK_THAT(again.messages, Catch::Contains("holds results already"));
    CHECK(contents(own.folder / "results.jsonl") == results);
}

TEST_CASE("the manifest lists what the run writes, and --overwrite removes that and no more") {
    const OwnedFolder own;
    REQUIRE(own.run().code == 0);
    const std::vector<std::string> files = own.manifest()["files"];
    for (const auto& entry : std::filesystem::recursive_directory_iterator(own.folder)) {
        const std::string path = std::filesystem::relative(entry.path(), own.folder).string();
        if (entry.is_directory() || path.starts_with(".lock")) { continue; }
        CAPTURE(path);
        CHECK(OwnedFiles(own.folder).has(path));
    }
    CHECK(std::find(files.begin(), files.end(), "trajectories/*.csv") != files.end());
    CHECK_FALSE(OwnedFiles(own.folder).has("trajectories/mine.csv"));
    OwnedFiles(own.folder).remove_results("", any_cell);
    CHECK(std::filesystem::is_empty(own.folder / "trajectories"));
    CHECK_FALSE(std::filesystem::exists(own.folder / "journal.jsonl"));
    CHECK(read_sum_list(own.folder).sums.empty());  // what is removed is not missing
}

TEST_CASE("a run that is killed while --overwrite removes results is resumed") {
    const OwnedFolder own;
    REQUIRE(own.run().code == 0);
    REQUIRE(run_program({"table", own.folder.string()}).code == 0);
    const std::string results = contents(own.folder / "results.jsonl");
    OwnedFiles(own.folder).remove_results("", any_cell);
    REQUIRE_FALSE(std::filesystem::exists(own.folder / "results.jsonl"));
    const auto resumed = own.run({"--resume"});
    CAPTURE(resumed.messages);
    CHECK(resumed.code == 0);
    CHECK(contents(own.folder / "results.jsonl") == results);
    CHECK_FALSE(OwnedFiles(own.folder).empty());
    std::filesystem::remove(own.folder / "manifest.json");
    std::filesystem::remove(own.folder / "journal.jsonl");
    CHECK(own.run({"--resume"}).code == 2);  // what nobody owns is refused still
}

TEST_CASE("a part that is overwritten leaves the samples of other parts alone, and a whole run owns what all had") {
    const OwnedFolder own;
    for (const char* shard : {"1/2", "2/2"}) { REQUIRE(own.run({"--shard", shard}).code == 0); }
    REQUIRE(own.run({"--shard", "2/2", "--overwrite"}).code == 0);
    const auto merged = run_program({"merge", own.folder.string(), "-o", (own.scratch / "merged").string()});
    CAPTURE(merged.messages);
    CHECK(merged.code == 0);
    OwnedFiles(own.folder).remove_results("", any_cell);  // and killed
    CHECK(std::filesystem::is_empty(own.folder / "trajectories"));
    CHECK(shard_files(own.folder, "manifest", ".json") == std::vector{own.folder / "manifest.json"});
    CHECK(own.run({"--resume"}).code == 0);
    CHECK(contents(own.folder / "results.jsonl") == contents(own.scratch / "merged/results.jsonl"));
}

TEST_CASE("a merge that has ended halfway is done again") {
    const OwnedFolder own;
    REQUIRE(own.run().code == 0);
    const auto target = own.scratch / "merged";
    const std::vector<std::string> merge = {"merge", own.folder.string(), "-o", target.string()};
    std::filesystem::create_directories(target / "geometry.json");
    CHECK(run_program(merge).code == 3);
    CHECK(std::filesystem::exists(target / "journal.jsonl"));
    std::filesystem::remove(target / "geometry.json");
    std::ofstream(target / "trajectories/0123456789abcdef.csv.77.part") << "torn";
    const auto again = run_program(merge);
    CAPTURE(again.messages);
    CHECK(again.code == 0);
    CHECK(contents(target / "results.jsonl") == contents(own.folder / "results.jsonl"));
    CHECK_FALSE(std::filesystem::exists(target / "trajectories/0123456789abcdef.csv.77.part"));
}

TEST_CASE("names that leave the folder are never followed") {
    for (const char* path : {"", "/etc/passwd", "../x", "a/../../x", "a/./b", "a//b", "a/", ".", ".."}) {
        CAPTURE(path);
        CHECK_FALSE(is_path_below(path));
    }
    CHECK(is_path_below("a/b.csv"));
    const OwnedFolder own;
    REQUIRE(own.run().code == 0);
    const std::string outside = own.scratch.file("outside.txt", "mine");
    auto forged = own.manifest();
    forged["files"].push_back("../outside.txt");
    forged["files"].push_back("trajectories/../../outside.txt");
    write_summed(own.folder / "manifest.json", forged);
    REQUIRE(own.run({"--overwrite"}).code == 0);
    CHECK(contents(outside) == "mine");

    std::string line = contents(own.folder / "journal.jsonl");
    line = line.substr(0, line.find('\n'));
    auto cell = nlohmann::ordered_json::parse(line);
    cell["cell"] = "../../outside";
    std::ofstream(own.folder / "journal.jsonl", std::ios::app) << summed_line(cell.dump()) << "\n";
    const auto merged = run_program({"merge", own.folder.string(), "-o", (own.scratch / "merged").string()});
    CHECK(merged.code == 3);
    CHECK_THAT(merged.messages, Catch::Contains("journal.jsonl:3: damaged line left out"));
}

TEST_CASE("parts that no journal line asks for are removed by the next run") {
    const OwnedFolder own;
    REQUIRE(own.run().code == 0);
    const auto line =
        read_journal_line(
            contents(own.folder / "journal.jsonl").substr(0, contents(own.folder / "journal.jsonl").find('\n')))
            .value();
    own.write("trajectories/00000000000000aa.csv.part", "t [s]\n");
    own.write("trajectories/00000000000000bb.csv.part", "t [s]\n");
    own.write("trajectories/mine.csv.part", "t [s]\n");
    own.write("results.csv.4711.part", "half");
    own.write("notes.4711.part", "half");
    CellRecord interrupted = line.record;
    interrupted.identity.cell = "00000000000000bb";
    interrupted.outcome.status = status::interrupted;
    std::ofstream(own.folder / "journal.jsonl", std::ios::app) << journal_line(interrupted, line.build) << "\n";
    REQUIRE(own.run({"--resume"}).code == 0);
    CHECK_FALSE(std::filesystem::exists(own.folder / "trajectories/00000000000000aa.csv.part"));
    CHECK(std::filesystem::exists(own.folder / "trajectories/00000000000000bb.csv.part"));
    CHECK(std::filesystem::exists(own.folder / "trajectories/mine.csv.part"));
    CHECK_FALSE(std::filesystem::exists(own.folder / "results.csv.4711.part"));
    CHECK(std::filesystem::exists(own.folder / "notes.4711.part"));
    CHECK(contents(own.folder / "results.jsonl").find("00bb") == std::string::npos);
}

TEST_CASE("manifests keep earlier runs, and merged ones those of the parts") {
    const OwnedFolder own;
    REQUIRE(own.run().code == 0);
    const auto first = own.manifest();
    CHECK_FALSE(first.contains("earlier"));
    REQUIRE(own.run({"--resume"}).code == 0);
    REQUIRE(own.run({"--resume"}).code == 0);
    const auto third = own.manifest();
    REQUIRE(third["earlier"].size() == 2);
    CHECK(third["earlier"][0]["started"] == first["started"]);
    CHECK(nlohmann::json(third["earlier"][0]["program"]) == nlohmann::json(first["program"]));
    const auto merged = own.scratch / "merged";
    REQUIRE(run_program({"merge", own.folder.string(), "-o", merged.string()}).code == 0);
    const auto manifest = nlohmann::json::parse(contents(merged / "manifest.json"));
    CHECK(manifest["earlier"].size() == 3);
    CHECK(manifest["earlier"][2]["started"] == third["started"]);
    CHECK(manifest["files"] == third["files"]);
    std::filesystem::remove(merged / "manifest.json");
    const auto again = run_program({"merge", own.folder.string(), "-o", merged.string()});
    CHECK(again.code == 2);
    CHECK_THAT(again.messages, Catch::Contains("expected nothing at this name"));
}

TEST_CASE("what is planned and missing is told by table, by name") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("good.json", good_config());
    const auto folder = (scratch / "half").string();
    REQUIRE(run_program({"run", config, "-o", folder, "--shard", "1/2"}).code == 0);
    REQUIRE(run_program({"merge", folder}).code == 3);
    const auto table = run_program({"table", folder});
    CHECK(table.code == 0);
    const std::string written = contents(scratch / "half" / "tables" / "not_ok.csv");
    CHECK(std::count(written.begin(), written.end(), '\n') == 7);
    CHECK_THAT(written, Catch::Contains("missing,no result"));
}

TEST_CASE("table refuses to write over a table that is not listed, and removes only its own") {
    const OwnedFolder own;
    own.write("tables/orders.csv", "mine");
    REQUIRE(own.run().code == 0);
    const auto refused = run_program({"table", own.folder.string()});
    CHECK(refused.code == 3);
    CHECK_THAT(refused.messages, Catch::Contains("tables/orders.csv: expected nothing at this name"));
    CHECK(contents(own.folder / "tables/orders.csv") == "mine");
    std::filesystem::remove(own.folder / "tables/orders.csv");
    REQUIRE(run_program({"table", own.folder.string()}).code == 0);
    SumList list = read_sum_list(own.folder);
    list.sums["tables/stale.csv"] = std::string(64, 'a');
    write_sum_list(own.folder, list);
    own.write("tables/stale.csv", "of an earlier run");
    own.write("tables/mine.csv", "mine");
    run_program({"table", own.folder.string()});
    CHECK_FALSE(std::filesystem::exists(own.folder / "tables/stale.csv"));
    CHECK(std::filesystem::exists(own.folder / "tables/mine.csv"));
}

TEST_CASE("plot refuses to write over what gnuplot reads if that is not its own") {
    const OwnedFolder own;
    REQUIRE(own.run().code == 0);
    own.write("plotdata/own.gp", "mine");
    const auto refused = run_program({"plot", own.folder.string()});
    CHECK(refused.code == 3);
    CHECK_THAT(refused.messages, Catch::Contains("plotdata/own.gp: expected nothing at this name"));
    CHECK(contents(own.folder / "plotdata/own.gp") == "mine");
    CHECK_FALSE(read_sum_list(own.folder).has("figures/own.svg"));
    own.write("plotdata/own.gp", "# Written by kreisel plot.\nold = 1\n");
    CHECK_THAT(run_program({"plot", own.folder.string()}).messages, !Catch::Contains("expected nothing at this name"));
    CHECK_THAT(contents(own.folder / "plotdata/own.gp"), !Catch::Contains("old = 1"));
}

TEST_CASE("figures and page of a folder are its own also where the folder is given by -o") {
    const OwnedFolder own;
    REQUIRE(own.run().code == 0);
    const std::string folder = own.folder.string();
    for (const std::vector<std::string>& words : {std::vector<std::string>{"plot", folder, "-o", folder + "/"},
                                                  {"plot", folder},
                                                  {"report", folder, "-o", folder + "/report.html"},
                                                  {"report", folder}}) {
        const auto result = run_program(words);
        CAPTURE(words, result.messages);
        CHECK(result.code == 0);
        CHECK(sum_list_damage(own.folder).empty());
    }
    CHECK(read_sum_list(own.folder).has("figures/own.svg"));
    CHECK(read_sum_list(own.folder).has("report.html"));
}

TEST_CASE("a figure that cannot be drawn is not listed as one that is there") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("bare.json", R"({"name": "bare", "kind": "drift", "problems": ["heavy_top"],
        "methods": ["rkmk/rk4"], "time": {"end": 0.01, "steps": [2]}})");
    const auto folder = scratch / "out";
    REQUIRE(run_program({"run", config, "-o", folder.string()}).code == 0);
    const auto plotted = run_program({"plot", folder.string()});
    CHECK(plotted.code == 1);
    CHECK_FALSE(read_sum_list(folder).has("figures/bare.svg"));
    CHECK(read_sum_list(folder).has("results.csv"));
}

TEST_CASE("table and plot wait for nobody: a locked folder is an error") {
    const OwnedFolder own;
    REQUIRE(own.run().code == 0);
    const FolderLock lock(own.folder, "");
    for (const char* command : {"table", "plot"}) {
        const auto result = run_program({command, own.folder.string()});
        CHECK(result.code == 3);
        CHECK_THAT(result.messages, Catch::Contains("another run is writing to this folder"));
    }
}

TEST_CASE("merge takes several builds only if it is told to") {
    const OwnedFolder own;
    REQUIRE(own.run().code == 0);
    auto manifest = own.manifest();
    manifest["program"]["build"] = "another_build_id";
    write_summed(own.folder / "manifest.json", manifest);
    std::string text;
    std::istringstream lines(contents(own.folder / "journal.jsonl"));
    for (std::string line; std::getline(lines, line);) {
        text += journal_line(read_journal_line(line, build_id()).value(), "another_build_id") + "\n";
    }
    std::ofstream(own.folder / "journal.jsonl") << text;
    const std::string merged = (own.scratch / "merged").string();
    const auto refused = run_program({"merge", own.folder.string(), "-o", merged});
    CHECK(refused.code == 2);
    CHECK_THAT(refused.messages, Catch::Contains("--mixed"));
    CHECK(run_program({"merge", own.folder.string(), "-o", merged, "--mixed"}).code == 0);
    CHECK(contents(own.scratch / "merged" / "results.jsonl") == contents(own.folder / "results.jsonl"));
    CHECK_THAT(contents(own.scratch / "merged" / "journal.jsonl"), Catch::Contains("another_build_id"));
}
