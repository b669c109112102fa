// SPDX-License-Identifier: BSD-3-Clause
//
// What kreisel slurm writes and refuses. Whether it works is tested on a cluster (tests/cluster).
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "driver/cli/slurm/time_limit.hpp"
#include "driver/plan/plan.hpp"
#include "records/json/strict.hpp"
#include "support/files.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;

namespace {

bool mentions(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

ProgramResult slurm(const std::string& config, const std::filesystem::path& folder,
                    std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"slurm", config, "-o", folder.string()});
    return run_program(more);
}

std::vector<std::string> hashes(const Plan& plan) {
    std::vector<std::string> all;
    for (const PlannedCell& planned : plan.cells) { all.push_back(planned.hash()); }
    return all;
}

}  // namespace

TEST_CASE("times are read as Slurm reads them") {
    const std::pair<const char*, double> times[] = {
        {"30", 1800}, {"30:15", 1815}, {"2:30:15", 9015}, {"1-12", 129600}, {"1-12:30", 131400}, {"1-12:30:15", 131415},
    };
    for (const auto& [written, seconds] : times) {
        INFO(written);
        CHECK(slurm_seconds(written) == seconds);
    }
    for (const char* wrong : {"", "0", "0:00", "1h", "1:2:3:4", "1-", "-1", "1-2-3", "1.5", " 1", "99999999999"}) {
        INFO(wrong);
        CHECK_FALSE(slurm_seconds(wrong).has_value());
    }
}

TEST_CASE("the config that is written gives the plan that was checked") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", good_config());
    const auto out = scratch / "out";
    REQUIRE(slurm(config, out, {"--set", "/time/end=0.5", "--filter", "methods=rkmk/midpoint"}).code == 0);
    const Plan written = plan_of(parse_document("config.json", contents(out / "config.json")), one_engine);
    Plan expected = plan_of(parse_document("c.json", good_config()), one_engine);
    CHECK(written.cells.size() < expected.cells.size());
    for (const PlannedCell& planned : written.cells) {
        CHECK(planned.cell().method == "rkmk/midpoint");
        CHECK(planned.cell().t_end == 0.5);
    }
    REQUIRE(slurm(config, scratch / "all").code == 0);
    CHECK(hashes(plan_of(parse_document("t", contents(scratch / "all" / "config.json")), one_engine)) ==
          hashes(expected));
}

TEST_CASE("the script is one that bash reads, whatever the folder is called") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", good_config());
    for (const char* name : {"plain", "two words", "it's", "$HOME", "a;b", "per%cent", "`x`", "line\nbreak", "\"q\""}) {
        const auto out = scratch / name;
        INFO(out);
        REQUIRE(slurm(config, out, {"--cpus", "4", "--time", "2:00:00", "--", "--comment=a b'c"}).code == 0);
        CHECK(mentions(contents(out / "submit.sh"), "--comment=a b'\\''c"));
        ::setenv("KREISEL_TEST_SCRIPT", (out / "submit.sh").c_str(), 1);
        ::setenv("KREISEL_TEST_FOLDER", out.c_str(), 1);
        CHECK(std::system("bash -n \"$KREISEL_TEST_SCRIPT\"") == 0);
        CHECK(std::system("bash -c 'source <(grep -v ^set \"$KREISEL_TEST_SCRIPT\" | sed \"/^achieved/,\\$d\") && "
                          "[[ $folder == \"$KREISEL_TEST_FOLDER\" && ${#options[@]} == 4 ]]'") == 0);
    }
}

TEST_CASE("parts are put together once what killed tasks have left running is at an end") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", good_config());
    REQUIRE(slurm(config, scratch / "out", {"--shards", "3"}).code == 0);
    ::setenv("KREISEL_TEST_FOLDER", (scratch / "out").c_str(), 1);
    CHECK(std::system("cd \"$KREISEL_TEST_FOLDER\" && sed -i 's/^kreisel=.*/kreisel=true/' submit.sh && mkdir slurm &&"
                      "exec 9>slurm/part-3.lock && flock 9 || exit 1; bash submit.sh merge 9>&- & sleep 0.3;"
                      "kill -0 $! && exec 9>&- && wait $!") == 0);
}

TEST_CASE("jobs are as many as there are cells to run, and at most ten") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", good_config());
    REQUIRE(slurm(config, scratch / "usual").code == 0);
    CHECK(mentions(contents(scratch / "usual" / "submit.sh"), "\nparts=10\n"));
    REQUIRE(slurm(config, scratch / "few", {"--filter", "methods=rkmk/midpoint"}).code == 0);
    CHECK(mentions(contents(scratch / "few" / "submit.sh"), "\nparts=4\n"));
    const auto many = slurm(config, scratch / "many", {"--shards", "13"});
    CHECK(many.code == 2);
    CHECK(mentions(many.messages, "--shards: expected at most 12, the cells that are to run, got 13"));
    CHECK_FALSE(std::filesystem::exists(scratch / "many"));
}

TEST_CASE("what kreisel slurm has not written stays, and its own is replaced") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", good_config());
    const auto out = scratch / "out";
    REQUIRE(slurm(config, out).code == 0);
    REQUIRE(slurm(config, out, {"--time", "30"}).code == 0);
    CHECK(mentions(contents(out / "submit.sh"), "--time=30"));
    for (const char* name : {"submit.sh", "config.json"}) {
        const std::string before = contents(out / name), changed = before + "# mine\n";
        write_atomically(out / name, changed);
        const auto refused = slurm(config, out);
        CHECK(refused.code == 2);
        CHECK(mentions(refused.messages, (out / name).string() + ": expected nothing at this name"));
        CHECK(contents(out / name) == changed);
        write_atomically(out / name, before);
    }
    CHECK(slurm(config, out).code == 0);
}

TEST_CASE("a folder with parts of another plan is refused before anything is submitted") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", good_config());
    const auto out = scratch / "out";
    REQUIRE(run_program({"run", config, "--shard", "1/3", "-o", out.string()}).code == 0);
    const auto refused = slurm(config, out, {"--shards", "4"});
    CHECK(refused.code == 2);
    CHECK(mentions(refused.messages, "expected a part of the plan"));
    CHECK_FALSE(std::filesystem::exists(out / "submit.sh"));
    CHECK(slurm(config, out, {"--shards", "3"}).code == 0);
}

TEST_CASE("refusals of kreisel slurm name what was expected") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", good_config());
    const std::pair<std::vector<std::string>, const char*> cases[] = {
        {{"--time", "soon"}, "expected a time as Slurm writes it"},
        {{"--cpus", "0"}, "0"},
        {{"--shard", "3"}, "did you mean \"--shards\"?"},
        {{"--", "other.json"}, "expected --OPTION or --OPTION=VALUE for sbatch after --, got \"other.json\""},
    };
    for (const auto& [words, phrase] : cases) {
        const auto result = slurm(config, scratch / "out", words);
        INFO(result.messages);
        CHECK(result.code == 2);
        CHECK(mentions(result.messages, phrase));
    }
    CHECK(slurm(config, scratch / "back\\slash").code == 2);
    CHECK_FALSE(std::filesystem::exists(scratch / "out"));
}

TEST_CASE("what a single cell may take beyond the limit is warned of") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", good_config());
    CHECK_FALSE(mentions(slurm(config, scratch / "a", {"--time", "1:00:00"}).messages, "warning"));
    const auto warned =
        slurm(config, scratch / "b", {"--time", "5", "--set", "/time/steps=1000000000", "--set", "/output/samples=0"});
    CHECK(warned.code == 0);
    CHECK(mentions(warned.messages, "warning: --time 5: some cell or reference may take"));
}

TEST_CASE("a script that cannot submit is an error of the program too") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", good_config());
    const std::string path = std::getenv("PATH");
    const std::filesystem::path tools = scratch / "tools";
    std::filesystem::create_directory(tools);
    std::filesystem::create_symlink("/bin/bash", tools / "bash");
    std::filesystem::create_symlink("/usr/bin/env", tools / "env");
    ::setenv("PATH", tools.c_str(), 1);
    const auto result = slurm(config, scratch / "out", {"--submit"});
    ::setenv("PATH", path.c_str(), 1);
    CHECK(result.code == 3);
    CHECK(mentions(result.messages, "submit.sh: has failed"));
}

TEST_CASE("a job that sbatch does not take is an error of script and program, also at the second time") {
    const ScratchFolder scratch;
    const std::string config = scratch.file("c.json", good_config());
    const auto tools = scratch / "tools";
    std::filesystem::create_directory(tools);
    const std::string path = std::getenv("PATH");
    const auto submitted = [&](const std::string& sbatch) {
        std::ofstream(tools / "sbatch") << "#!/bin/sh\n" << sbatch << "\n";
        std::ofstream(tools / "squeue") << "#!/bin/sh\nexit 1\n";
        for (const char* name : {"sbatch", "squeue"}) {
            std::filesystem::permissions(tools / name, std::filesystem::perms::owner_all);
        }
        ::setenv("PATH", (tools.string() + ":" + path).c_str(), 1);
        const auto result = slurm(config, scratch / "out", {"--submit"});
        ::setenv("PATH", path.c_str(), 1);
        return result.code;
    };
    CHECK(submitted("exit 1") == 3);
    CHECK(submitted("echo 4711") == 0);
    CHECK(contents(scratch / "out" / "slurm" / "jobs") == "4711\n4711\n4711\n");
    CHECK(submitted("[ \"$(wc -l < '" + (scratch / "out" / "slurm" / "jobs").string() + "')\" -lt 1 ] && echo 1") == 3);
    CHECK(contents(scratch / "out" / "slurm" / "jobs") == "1\n");
}
