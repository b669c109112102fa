// SPDX-License-Identifier: BSD-3-Clause
//
// Damage to every file of a small results folder: bytes changed, and cuts. Either a reader notices and names the file,
// or what it reads is the same.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <sstream>

#include "records/diff/recorded_folder.hpp"
#include "records/reading/read_results.hpp"
#include "records/reading/trajectory_table.hpp"
#include "records/results.hpp"
#include "records/sums/sum_list.hpp"
#include "records/sums/summed_text.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "tests/driver/harm/small_folder.hpp"

using namespace kreisel;

namespace {

/// The text with one byte changed, for each byte, and cut at each length; every `stride`-th of both.
template <class Visit>
void for_each_damage(const std::string& text, std::size_t stride, const Visit& visit) {
    for (std::size_t i = 0; i < text.size(); i += stride) {
        std::string changed = text;
        changed[i] = static_cast<char>(changed[i] ^ (1 << (i % 8)));
        visit(changed);
        visit(text.substr(0, i));
    }
}

bool names_file(const std::vector<std::string>& damage, const std::filesystem::path& file) {
    return std::any_of(damage.begin(), damage.end(), [&](const std::string& text) {
        return text.find(file.filename().string()) != std::string::npos;
    });
}

std::string numbers_text(const NamedNumbers& numbers) {
    std::string text;
    for (const auto& [name, value] : numbers) { text += fmt::format(" {} {}", name, value); }
    return text;
}

/// All that tables and figures are made from.
std::string everything(const Results& results) {
    std::string text = results.name + results.kind + results.config;
    for (const auto& [name, unit] : results.units) { text += name + unit; }
    for (const ResultRow& row : results.rows) {
        text += fmt::format("{} {} {} {} {} {} {}", row.cell, row.label, row.method, row.status, row.detail, row.steps,
                            row.t_end);
        text += numbers_text(row.metrics) + numbers_text(row.scale) + numbers_text(row.cost) +
                numbers_text(row.reference_error);
        if (!row.has_trajectory) { continue; }
        for (const auto& column : read_trajectory(row).columns) { text += fmt::format(" {}", fmt::join(column, " ")); }
    }
    return text;
}

std::string everything(const RecordedFolder& recorded) {
    std::string text;
    for (const RecordedCell& cell : recorded.cells) {
        text += cell.cell + cell.label + cell.status + cell.trajectory_sum;
        for (const auto& [name, value] : cell.identity) { text += name + value; }
        for (const auto* part : {&cell.final_state, &cell.metrics, &cell.others}) {
            for (const auto& [name, quantity] : *part) { text += fmt::format(" {} {}", name, quantity.number.value); }
        }
    }
    return text;
}

/// Everything that a run leaves but times and messages.
std::string outputs(const std::filesystem::path& folder) {
    std::string text = contents(folder / "results.jsonl") + contents(folder / "results.csv");
    for (const auto& entry : std::filesystem::directory_iterator(folder / "trajectories")) {
        text += contents(entry.path());
    }
    return text;
}

}  // namespace

TEST_CASE("a sum holds for no text with a changed byte, and for no beginning of a text") {
    const SmallFolder small;
    std::size_t tried = 0, held = 0;
    const auto count = [&](const std::string& text, const SumStyle& style) {
        REQUIRE(sum_state(text, style) == SumState::holds);
        for_each_damage(text, 1, [&](const std::string& damaged) {
            ++tried;
            held += sum_state(damaged, style) == SumState::holds ? 1U : 0U;
        });
    };
    for (const char* name : {"results.jsonl", "journal.jsonl"}) {
        std::istringstream lines(contents(small.folder / name));
        for (std::string line; std::getline(lines, line);) { count(line, compact_sum); }
    }
    count(contents(small.folder / "manifest.json"), indented_sum);
    const auto list = small.folder / "sums.sha256";
    const std::string text = contents(list);
    for_each_damage(text, 1, [&](const std::string& damaged) {
        put(list, damaged);
        ++tried;
        held += read_sum_list(small.folder).damage.empty() ? 1U : 0U;
    });
    CHECK(held == 0);
    CHECK(tried > 10'000);
}

TEST_CASE("what is changed or cut in a results folder is noticed by its readers, or changes nothing") {
    const SmallFolder small;
    const Results good = read_results(small.folder);
    REQUIRE(good.damage.empty());
    REQUIRE(good.rows.size() == 2);
    const std::string before = everything(good), recorded = everything(read_recorded_folder(small.folder));
    for (const auto& file : small.files()) {
        CAPTURE(file.string());
        const std::string text = contents(file);
        std::size_t silent = 0, unnamed = 0, noticed = 0;
        for_each_damage(text, 11, [&](const std::string& damaged) {
            put(file, damaged);
            const Results read = read_results(small.folder);
            noticed += read.damage.empty() ? 0U : 1U;
            unnamed += read.damage.empty() || names_file(read.damage, file) ? 0U : 1U;
            silent += read.damage.empty() && everything(read) != before ? 1U : 0U;
        });
        for_each_damage(text, 29, [&](const std::string& damaged) {
            put(file, damaged);
            const RecordedFolder read = read_recorded_folder(small.folder);
            unnamed += read.damage.empty() || names_file(read.damage, file) ? 0U : 1U;
            silent += read.damage.empty() && everything(read) != recorded ? 1U : 0U;
        });
        put(file, text);
        CHECK(silent == 0);
        CHECK(unnamed == 0);
        CHECK(noticed >= 2 * (text.size() / 11));
    }
}

TEST_CASE("damage ends each command with 3, and never in raw text of a library") {
    const SmallFolder small;
    const std::string before = contents(small.folder / "results.jsonl");
    for (const auto& file : small.files()) {
        const std::string text = contents(file);
        const std::size_t stride = text.size() / 3 + 1;
        for_each_damage(text, stride, [&](const std::string& damaged) {
            put(file, damaged);
            for (const std::vector<std::string>& words :
                 {std::vector<std::string>{"verify", small.folder.string()},
                  {"diff", small.folder.string(), small.folder.string()},
                  {"merge", small.folder.string(), "-o", (small.scratch / "merged").string()},
                  {"table", small.folder.string()}}) {
                put(file, damaged);
                const auto result = run_program(words);
                CAPTURE(file.string(), words.front(), result.messages);
                CHECK(result.code != 4);
                CHECK(result.messages.find("json.exception") == std::string::npos);
                CHECK(result.messages.find("syntax error") == std::string::npos);
                if (result.code == 3) {
                    CHECK_THAT(result.messages, Catch::Contains(file.filename().string()));
                } else if (words.front() == "merge") {
                    CHECK(contents(small.scratch / "merged" / "results.jsonl") == before);
                } else {
                    CHECK(result.code == 0);
                }
            }
        });
        put(file, text);
        run_program({"table", small.folder.string()});
    }
}

TEST_CASE("a table that damage has taken away is damage, and no wrong name") {
    const SmallFolder small;
    const auto ask = [&] { return run_program({"table", small.folder.string(), "--table", "orders"}).code; };
    CHECK(ask() == 0);
    CHECK(run_program({"table", small.folder.string(), "--table", "order"}).code == 2);
    put(small.folder / "results.jsonl", "");
    CHECK(ask() == 3);
}

TEST_CASE("a file of a run that is missing is named by each reader") {
    const SmallFolder small;
    const std::string folder = small.folder.string();
    for (const char* name : {"journal.jsonl", "manifest.json", "results.csv", "geometry.json", "sums.sha256"}) {
        const std::string text = contents(small.folder / name);
        std::filesystem::remove(small.folder / name);
        CHECK(names_file(read_results(small.folder).damage, name));
        CHECK(names_file(read_recorded_folder(small.folder).damage, name));
        CHECK(run_program({"verify", folder, "--cells", "0"}).code == 3);
        put(small.folder / name, text);
        CHECK(read_results(small.folder).damage.empty());
    }
    const std::string lines = contents(small.folder / "results.jsonl");
    std::filesystem::remove(small.folder / "results.jsonl");
    for (const char* command : {"table", "plot", "report", "verify"}) {
        const auto result = run_program({command, folder});
        CHECK(result.code == 3);
        CHECK_THAT(result.messages, Catch::Contains("results.jsonl"));
    }
    const RecordedFolder recorded = read_recorded_folder(small.folder);
    CHECK(names_file(recorded.damage, "results.jsonl"));
    CHECK(recorded.cells.size() == 2);  // of the journal
    put(small.folder / "results.jsonl", lines);
    std::filesystem::remove(small.folder / "tables" / "orders.csv");
    CHECK(read_results(small.folder).damage.empty());
}

TEST_CASE("a part whose manifest is missing cannot be merged, and a folder without results says why") {
    const SmallFolder small;
    const std::string merged = (small.scratch / "merged").string();
    std::filesystem::remove(small.folder / "manifest.json");
    const auto merge = run_program({"merge", small.folder.string(), "-o", merged});
    CHECK(merge.code == 3);
    CHECK_THAT(merge.messages, Catch::Contains("manifest.json: damaged: it is not there"));
    std::filesystem::create_directory(small.scratch / "empty");
    CHECK(run_program({"merge", (small.scratch / "empty").string(), "-o", merged}).code == 2);
    std::filesystem::remove(small.folder / "results.jsonl");
    CHECK_THAT(run_program({"table", small.folder.string()}).messages, Catch::Contains("--resume goes on"));
    CHECK_THAT(run_program({"table", (small.scratch / "empty").string()}).messages,
               !Catch::Contains("--resume goes on"));
}

TEST_CASE(
    "a part whose manifest is damaged is named and stops no merge: its intact lines are taken, what is missing told") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("good.json", good_config());
    const auto run = [&](const std::string& folder, const std::vector<std::string>& more) {
        std::vector<std::string> words = {"run", config, "-o", (scratch / folder).string(), "-j", "1"};
        words.insert(words.end(), more.begin(), more.end());
        REQUIRE(run_program(words).code == 0);
    };
    run("a", {"--shard", "1/2"});
    run("b", {"--shard", "2/2"});
    run("whole", {});
    const auto manifest = scratch / "b" / "manifest.2-of-2.json", journal = scratch / "b" / "journal.2-of-2.jsonl";
    const auto merge = [&](const std::string& first, const std::string& second, const std::string& into) {
        return run_program(
            {"merge", (scratch / first).string(), (scratch / second).string(), "-o", (scratch / into).string()});
    };
    std::string text = contents(manifest);
    text[text.size() / 2] = '#';
    put(manifest, text);
    const auto merged = merge("a", "b", "ab");
    CHECK(merged.code == 3);
    CHECK_THAT(merged.messages, Catch::Contains("manifest.2-of-2.json: damaged: its sum does not hold"));
    CHECK(contents(scratch / "ab" / "results.jsonl") == contents(scratch / "whole" / "results.jsonl"));
    std::filesystem::remove(manifest);
    const auto lost = merge("a", "b", "ab");
    CHECK(lost.code == 3);
    CHECK_THAT(lost.messages, Catch::Contains("manifest.2-of-2.json: damaged: it is not there"));
    CHECK(contents(scratch / "ab" / "results.jsonl") == contents(scratch / "whole" / "results.jsonl"));
    put(manifest, text);
    const std::string lines = contents(journal);
    put(journal, lines.substr(0, lines.find('\n') + 1));
    const auto fewer = merge("b", "a", "ba");  // the damaged one first
    CHECK(fewer.code == 3);
    CHECK_THAT(fewer.messages, Catch::Contains("missing: rkmk/"));
    CHECK_THAT(fewer.messages, Catch::Contains("compute what is missing with: kreisel run "));
    CHECK(run_program({"run", (scratch / "ba" / "manifest.json").string(), "-o", (scratch / "ba").string(), "--resume"})
              .code == 0);
    CHECK(contents(scratch / "ba" / "results.jsonl") == contents(scratch / "whole" / "results.jsonl"));
    const auto onto = merge("a", "b", "b");
    CHECK(onto.code == 3);
    CHECK_THAT(onto.messages, Catch::Contains("-o FOLDER merges into another folder"));
    CHECK(run_program({"merge", (scratch / "b").string(), "-o", (scratch / "bb").string()}).code == 3);
}

TEST_CASE("a resume says what is damaged, and computes it again to the same bytes") {
    const SmallFolder small;
    const std::string before = outputs(small.folder);
    for (const auto& file : small.files()) {
        const std::string text = contents(file);
        for_each_damage(text, text.size() / 3 + 1, [&](const std::string& damaged) {
            put(file, damaged);
            const auto result = run_program({"run", small.config, "-o", small.folder.string(), "--resume"});
            CAPTURE(file.string(), result.messages);
            CHECK(result.code == 0);
            CHECK(outputs(small.folder) == before);
            const bool is_read = file.extension() == ".jsonl" ? file.stem() == "journal"
                                                              : file.parent_path().filename() == "trajectories";
            if (is_read) { CHECK_THAT(result.messages, Catch::Contains(file.filename().string())); }
            const auto verified = run_program({"verify", small.folder.string(), "--cells", "0"});
            CAPTURE(verified.messages);
            CHECK(verified.code == 0);
        });
    }
}

TEST_CASE("sha256sum checks the listed files") {
    const SmallFolder small;
    const std::string command =
        "cd '" + small.folder.string() + "' && sha256sum --check --strict --quiet sums.sha256 2>&1";
    CHECK(std::system(command.c_str()) == 0);
    CHECK_THAT(contents(small.folder / "sums.sha256"), Catch::Contains("  results.csv\n"));
    CHECK_THAT(contents(small.folder / "sums.sha256"), Catch::Contains("  results.jsonl\n"));
    CHECK_THAT(contents(small.folder / "sums.sha256"), Catch::Contains("  tables/orders.tex\n"));
}

TEST_CASE("a folder of an older version is read with one warning, and is the same as a new one") {
    const SmallFolder small;
    const auto old = small.scratch / "old";
    std::filesystem::create_directory(old);
    std::istringstream lines(contents(small.folder / "results.jsonl"));
    std::string text;
    for (std::string line; std::getline(lines, line);) { text += line.substr(0, line.rfind(",\"sum\":")) + "}\n"; }
    put(old / "results.jsonl", text);
    auto manifest = nlohmann::ordered_json::parse(contents(small.folder / "manifest.json"));
    for (const char* member : {"format", "sum", "files", "journal"}) { manifest.erase(member); }
    put(old / "manifest.json", manifest.dump(2) + "\n");
    std::filesystem::copy(small.folder / "trajectories", old / "trajectories");
    const std::string warning = old.string() + ": warning: written by an older version";
    const auto compared = run_program({"diff", old.string(), small.folder.string()});
    CHECK(compared.code == 0);
    CHECK_THAT(compared.messages, Catch::StartsWith(warning));
    CHECK(std::count(compared.messages.begin(), compared.messages.end(), '\n') == 1);
    const auto table = run_program({"table", old.string()});
    CHECK(table.code == 0);
    CHECK_THAT(table.messages, Catch::StartsWith(warning));
}
