// SPDX-License-Identifier: BSD-3-Clause
//
// A method that crashes, loops, hoards memory, prints or throws fails its own cell only, with a status that says how.
#include <catch2/catch.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/driver/command_line.hpp"
#include "tests/driver/workers/saboteurs.hpp"

using namespace kreisel;

namespace {

// A hundred good cells, and two of a saboteur.
std::string amid_good_cells(const std::string& saboteur) {
    nlohmann::json masses = nlohmann::json::array(), methods = {"rkmk/rk4"};
    for (int i = 1; i <= 50; ++i) { masses.push_back(i); }
    if (!saboteur.empty()) { methods.push_back(saboteur); }
    return nlohmann::json({{"name", "evil"},
                           {"kind", "drift"},
                           {"problems", {{{"name", "heavy_top"}, {"parameters", {{"mass", masses}}}}}},
                           {"methods", methods},
                           {"time", {{"end", 1}, {"steps", {2, 4}}}}})
        .dump();
}

struct Lines {
    std::string good;                    // those of the good method
    std::vector<nlohmann::json> others;  // of the saboteur
};

Lines lines_in(const std::filesystem::path& folder) {
    Lines lines;
    std::istringstream stream(contents(folder / "results.jsonl"));
    for (std::string line; std::getline(stream, line);) {
        const auto json = nlohmann::json::parse(line);
        if (json["method"] == "rkmk/rk4") { lines.good += line + "\n"; }
        if (json["method"] != "rkmk/rk4" && json["status"] != "skipped") { lines.others.push_back(json); }
    }
    return lines;
}

ProgramResult run(const ScratchFolder& scratch, const std::string& config, const std::string& name,
                  std::vector<std::string> more, const Saboteurs& engine = {}) {
    more.insert(more.begin(), {"run", scratch.file(name + ".json", config), "-o", (scratch / name).string()});
    return run_program(more, engine);
}

}  // namespace

TEST_CASE("a saboteur amid a hundred good cells fails its own cells only, whatever the number of workers") {
    const std::map<std::string, std::pair<std::string, std::string>> expected = {
        {"segfault", {"crashed(SIGSEGV)", "its process was ended by SIGSEGV"}},
        {"abort", {"crashed(SIGABRT)", "ended by SIGABRT"}},
        {"terminate", {"crashed(SIGABRT)", "terminate called"}},
        {"exit", {"crashed(exit 3)", "ended itself with exit code 3"}},
        {"overflow", {"crashed(SIGSEGV)", ""}},
        {"throw", {"exception", "thrown on purpose"}},
        {"close", {"crashed(SIGKILL)", ""}},
        {"print", {"ok", "it printed: a line and \"another\" an error"}},
        {"flood", {"ok", "it printed: xxxx"}},
    };
    const ScratchFolder scratch;
    run(scratch, amid_good_cells(""), "alone", {});
    const std::string good = lines_in(scratch / "alone").good;
    REQUIRE(std::count(good.begin(), good.end(), '\n') == 100);
    for (const auto& [name, end] : expected) {
        std::string all;
        for (const char* jobs : {"1", "2", "4"}) {
            INFO(name << " with " << jobs << " workers");
            const std::string folder = name + jobs;
            const auto result = run(scratch, amid_good_cells("sabotage/" + name), folder, {"-j", jobs});
            CHECK(result.code == (end.first == "ok" ? 0 : 1));
            const Lines lines = lines_in(scratch / folder);
            CHECK(lines.good == good);
            REQUIRE(lines.others.size() == 2);
            for (const auto& line : lines.others) {
                CHECK(line["status"] == end.first);
                const auto detail = line.value("detail", "");
                CHECK_THAT(detail, Catch::Contains(end.second));
                CHECK(detail.size() < 4300);
            }
            const std::string results = contents(scratch / folder / "results.jsonl");
            if (!all.empty()) { CHECK(results == all); }
            all = results;
        }
    }
}

TEST_CASE("limits of CPU time and memory end the cells that meet them, which a resume tries again") {
    const ScratchFolder scratch;
    run(scratch, amid_good_cells("sabotage/throw"), "other", {});
    const std::string good = lines_in(scratch / "other").good;
    REQUIRE(!good.empty());
    const std::vector<std::string> limits = {"--timeout", "0.3", "--max-memory", "256MB"};
    for (const char* jobs : {"1", "2", "4"}) {
        auto words = limits;
        words.insert(words.end(), {"-j", jobs});
        const std::pair<const char*, const char*> expected[] = {{"loop", "timeout"}, {"hoard", "out_of_memory"}};
        for (const auto& [name, status] : expected) {
            if (std::string(name) == "hoard") { words[1] = "20"; }  // far more than the allocation takes
            const std::string folder = std::string(name) + jobs;
            INFO(folder);
            CHECK(run(scratch, amid_good_cells(std::string("sabotage/") + name), folder, words).code == 1);
            const Lines lines = lines_in(scratch / folder);
            CHECK(lines.good == good);
            REQUIRE(lines.others.size() == 2);
            CHECK(lines.others[0]["status"] == status);
            CHECK(lines.others[1]["status"] == status);
        }
    }
    CHECK(lines_in(scratch / "loop2").others[0]["detail"] ==
          "it has taken the CPU time of 0.3 s that --timeout allows");
    CHECK(lines_in(scratch / "hoard2").others[0]["detail"] == "memory was refused; --max-memory allows 256 MB");
    const Saboteurs engine;
    auto again = limits;
    again.emplace_back("--resume");
    CHECK(run(scratch, amid_good_cells("sabotage/loop"), "loop2", again, engine).code == 1);
    CHECK(lines_in(scratch / "loop2").good == good);
    const std::string journal = contents(scratch / "loop2" / "journal.jsonl");
    CHECK(std::count(journal.begin(), journal.end(), '\n') == 200 + 2);  // the skipped ones too; two again
    CHECK(engine.runs == 0);
}

TEST_CASE("a cell that meets its share of the memory is run again alone with all of it, and that outcome counts") {
    const ScratchFolder scratch;
    const std::string config = amid_good_cells("sabotage/greedy");
    CHECK(run(scratch, config, "one", {"-j", "1", "--max-memory", "256MB"}).code == 0);
    CHECK(run(scratch, config, "four", {"-j", "4", "--max-memory", "256MB"}).code == 0);
    CHECK(contents(scratch / "one" / "results.jsonl") == contents(scratch / "four" / "results.jsonl"));
    CHECK(run(scratch, config, "none", {"-j", "1", "--max-memory", "64MB"}).code == 1);
    CHECK(lines_in(scratch / "none").others.at(0)["status"] == "out_of_memory");
}

TEST_CASE("a cell whose worker is killed is run again") {
    const ScratchFolder scratch;
    const Saboteurs engine;
    CHECK(run(scratch, amid_good_cells("sabotage/kill"), "killed", {"-j", "2"}, engine).code == 0);
    CHECK(engine.killed >= 1);
}

TEST_CASE("limits that are none are refused") {
    const ScratchFolder scratch;
    for (const char* option : {"--timeout", "--max-memory"}) {
        for (const char* value : {"0", "-1", "nan", "much"}) {
            INFO(option << " " << value);
            const auto result = run(scratch, amid_good_cells(""), "none", {option, value});
            CHECK(result.code == 2);
            CHECK_THAT(result.messages, Catch::Contains(option));
        }
    }
    CHECK_FALSE(std::filesystem::exists(scratch / "none"));
}

TEST_CASE("verify computes cells that crash and print again, and leaves out those that met a limit") {
    const ScratchFolder scratch;
    const Saboteurs engine;
    const auto verified = [&](const std::string& name, std::vector<std::string> limits) {
        run(scratch, amid_good_cells("sabotage/" + name), name, std::move(limits), engine);
        return run_program({"verify", (scratch / name).string(), "--cells", "102"}, engine);
    };
    for (const char* name : {"segfault", "print", "throw"}) {
        INFO(name);
        const auto result = verified(name, {});
        CHECK(result.code == 0);
        CHECK_THAT(result.out, Catch::Contains("102 of 200 cells computed again (seed 1), 0 differ or are missing"));
    }
    const auto result = verified("loop", {"--timeout", "0.2"});
    CHECK(result.code == 0);
    CHECK_THAT(result.out, Catch::Contains("2 cells that met a limit or have no reference are not computed again"));
    CHECK_THAT(result.out, Catch::Contains("100 of 200 cells computed again"));
}
