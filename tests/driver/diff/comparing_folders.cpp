// SPDX-License-Identifier: BSD-3-Clause
//
// kreisel diff on folders that the program has written.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "records/cell/line.hpp"
#include "records/provenance.hpp"
#include "records/sums/sum_list.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;

namespace {

/// The good config, run twice; and the output of diff for the two folders.
struct TwoFolders {
    ScratchFolder scratch;
    std::filesystem::path a = scratch / "a", b = scratch / "b";

    explicit TwoFolders(const std::string& config_text = good_config()) {
        const std::string config = scratch.file("good.json", config_text);
        for (const auto& folder : {a, b}) { REQUIRE(run_program({"run", config, "-o", folder.string()}).code <= 1); }
        // The manifest says how many lines there are, and a journal that there must be a manifest.
        for (const char* name : {"manifest.json", "journal.jsonl"}) { std::filesystem::remove(b / name); }
    }
    ProgramResult diff(std::vector<std::string> options = {}) const {
        options.insert(options.begin(), {"diff", a.string(), b.string()});
        return run_program(options);
    }
    std::vector<std::string> lines() const {
        std::istringstream stream(contents(b / "results.jsonl"));
        std::vector<std::string> all;
        for (std::string line; std::getline(stream, line);) { all.push_back(line); }
        return all;
    }
    void rewrite(const std::vector<std::string>& lines) const {
        std::ofstream file(b / "results.jsonl");
        for (const std::string& line : lines) { file << line << "\n"; }
        file.close();
        record_sums(b, {"results.jsonl"});
    }
    /// Replaces one value in one line of B.
    void set(std::size_t index, const std::string& pointer, const nlohmann::json& value) const {
        auto all = lines();
        auto line = nlohmann::ordered_json::parse(all.at(index));
        REQUIRE(line.contains(nlohmann::ordered_json::json_pointer(pointer)));
        line[nlohmann::ordered_json::json_pointer(pointer)] = value;
        all[index] = summed_line(line.dump());
        rewrite(all);
    }
    double number(std::size_t index, const std::string& pointer) const {
        return nlohmann::json::parse(lines().at(index)).at(nlohmann::json::json_pointer(pointer));
    }
};

}  // namespace

TEST_CASE("two runs of one config are the same, though their times are not") {
    const TwoFolders folders;
    const auto result = folders.diff();
    CHECK(result.code == 0);
    CHECK_THAT(result.out, Catch::Contains("12 cells in A, 12 in B: 12 are the same, 0 moved, 0 changed status, 0 in A "
                                           "only, 0 in B only\n"));
    CHECK(result.messages.empty());
}

TEST_CASE("a final state and a metric that are off by one ulp are seen") {
    for (const char* pointer : {"/final/bodies/0/x/1", "/metrics/error.position"}) {
        const TwoFolders folders;
        folders.set(7, pointer, std::nextafter(folders.number(7, pointer), INFINITY));
        const auto result = folders.diff();
        INFO(result.out);
        CHECK(result.code == 1);
        CHECK_THAT(result.out, Catch::Contains("11 are the same, 1 moved"));
        CHECK_THAT(result.out, Catch::Contains(pointer[1] == 'f' ? "final.x " : "error.position "));
        CHECK(folders.diff({"--within", "1e-12"}).code == 0);
    }
}

TEST_CASE("the last digit of a quad number is seen") {
    std::string config = good_config();
    config.insert(1, R"("precision": "quad",)");
    const TwoFolders folders(config);
    REQUIRE(folders.diff().code == 0);
    folders.set(0, "/final/multipliers/1", "-1.00000000000000000000000000000000019259e-30");
    const auto result = folders.diff();
    CHECK(result.code == 1);
    CHECK_THAT(result.out, Catch::Contains("final.multipliers"));
}

TEST_CASE("cells that one folder lacks are listed") {
    const TwoFolders folders;
    auto lines = folders.lines();
    lines.erase(lines.begin() + 3);
    folders.rewrite(lines);
    CHECK(folders.diff().code == 1);
    CHECK_THAT(folders.diff().out, Catch::Contains("Cells of one folder only"));
    CHECK_THAT(folders.diff().out, Catch::Contains("1 in A only, 0 in B only"));
    const auto back = run_program({"diff", folders.b.string(), folders.a.string()});
    CHECK(back.code == 1);
    CHECK_THAT(back.out, Catch::Contains("0 in A only, 1 in B only"));
}

TEST_CASE("a cell that changed status is listed with both") {
    const TwoFolders folders;
    folders.set(2, "/status", "newton_failed");
    const auto result = folders.diff({"--within", "0.5"});
    CHECK(result.code == 1);
    CHECK_THAT(result.out, Catch::Contains("Cells that changed status"));
    CHECK_THAT(result.out, Catch::Contains("newton_failed"));
}

TEST_CASE("without results.jsonl the journals are read, of any build") {
    const TwoFolders folders;
    std::filesystem::remove(folders.a / "results.jsonl");
    CHECK(folders.diff().code == 3);  // the run has come to its end, and has written it
    for (const char* name : {"results.csv", "sums.sha256"}) { std::filesystem::remove(folders.a / name); }
    std::filesystem::remove_all(folders.b);
    std::filesystem::copy(folders.a, folders.b, std::filesystem::copy_options::recursive);
    REQUIRE(folders.diff().code == 0);
    std::istringstream lines(contents(folders.b / "journal.jsonl"));
    std::string text;
    for (std::string line; std::getline(lines, line);) {
        CellRecord cell = read_journal_line(line, build_id()).value();
        cell.times.cpu_s += 1;
        text = journal_line(cell, "another, whose name is longer than a hash") + "\n" + text;
    }
    std::ofstream(folders.b / "journal.jsonl") << text;
    auto manifest = nlohmann::ordered_json::parse(contents(folders.b / "manifest.json"));
    manifest.erase("journal");  // how long it was
    write_summed(folders.b / "manifest.json", manifest);
    CHECK(folders.diff().code == 0);
    std::ofstream(folders.b / "journal.jsonl") << text << "rubbish\n";
    CHECK(folders.diff().code == 3);
    CHECK_THAT(folders.diff().messages, Catch::Contains("journal.jsonl:13: not a result line"));
}

TEST_CASE("a folder that is not a results folder ends with 3, and is named") {
    const TwoFolders folders;
    const auto empty = folders.scratch / "empty";
    std::filesystem::create_directory(empty);
    const std::string file = folders.scratch.file("a_file", "");
    for (const std::string& folder : {empty.string(), file, (folders.scratch / "absent").string()}) {
        for (const auto& words : {std::vector<std::string>{"diff", folder, folders.b.string()},
                                  std::vector<std::string>{"diff", folders.a.string(), folder}}) {
            const auto result = run_program(words);
            CHECK(result.code == 3);
            CHECK_THAT(result.messages, Catch::Contains(folder));
            CHECK(result.out.empty());
        }
    }
}

TEST_CASE("a damaged line is named, and the others are compared") {
    const TwoFolders folders;
    auto lines = folders.lines();
    lines[4] = lines[4].substr(0, 100);
    folders.rewrite(lines);
    const auto result = folders.diff();
    CHECK(result.code == 3);
    CHECK_THAT(result.messages, Catch::Contains("results.jsonl:5: not a result line"));
    CHECK_THAT(result.out, Catch::Contains("12 cells in A, 11 in B: 11 are the same"));
}

TEST_CASE("diff takes two folders and a tolerance that is positive") {
    const TwoFolders folders;
    CHECK(run_program({"diff", folders.a.string()}).code == 2);
    for (const char* tolerance : {"0", "-1", "nan", "inf", "small"}) {
        INFO(tolerance);
        CHECK(folders.diff({"--within", tolerance}).code == 2);
    }
    CHECK(folders.diff({"--csv", (folders.scratch / "no" / "d.csv").string()}).code == 3);
}

TEST_CASE("the CSV has a row for each difference") {
    const TwoFolders folders;
    folders.set(0, "/metrics/error.position", 2 * folders.number(0, "/metrics/error.position"));
    folders.set(1, "/final/bodies/0/v/2", 17.5);
    folders.set(2, "/status", "newton_failed");
    auto lines = folders.lines();
    lines.pop_back();
    folders.rewrite(lines);
    const auto file = folders.scratch / "d.csv";
    CHECK(folders.diff({"--csv", file.string()}).code == 1);
    std::istringstream csv(contents(file));
    std::vector<std::string> rows;
    for (std::string row; std::getline(csv, row);) { rows.push_back(row); }
    REQUIRE(rows.size() == 5);
    CHECK(rows[0] ==
          "difference,cell in A,cell in B,problem,label,formulation,method,options,projection,projection "
          "options,precision,steps,t_end [s],quantity,in A,in B,ulp,relative,of scale");
    CHECK_THAT(rows[1], Catch::StartsWith("cell only in A,"));
    CHECK_THAT(rows[2], Catch::Contains(",error.position,") && Catch::Contains(",0.5,"));
    CHECK_THAT(rows[3], Catch::Contains(".v.3,") && Catch::Contains(",17.5,"));
    CHECK_THAT(rows[4], Catch::Contains(",status,ok,newton_failed,"));
}

TEST_CASE("a long list is cut, and says so") {
    std::string config = good_config();
    config.replace(config.find("\"levels\": 2"), 11, "\"levels\": 5");
    const TwoFolders folders(config);
    for (std::size_t i = 0; i < folders.lines().size(); ++i) { folders.set(i, "/final/t", 2); }
    CHECK_THAT(folders.diff().out, Catch::Contains("The first 20 of 30; --csv FILE writes all."));
}
