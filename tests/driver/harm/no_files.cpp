// SPDX-License-Identifier: BSD-3-Clause
//
// Named pipes and folders at the names of files: whoever opens a pipe that nobody writes to waits for ever.
#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <thread>

#include "support/errors.hpp"
#include "support/files.hpp"
#include "tests/driver/harm/small_folder.hpp"

namespace kreisel::no_file_tests {

namespace fs = std::filesystem;

/// Ends the program if what it guards waits for ever.
class Alarm {
  public:
    Alarm() { ::alarm(120); }
    ~Alarm() { ::alarm(0); }
    Alarm(const Alarm&) = delete;
    Alarm& operator=(const Alarm&) = delete;
};

void make_pipe(const fs::path& path) {
    fs::remove_all(path);
    REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
}

void make_empty_folder(const fs::path& path) {
    fs::remove_all(path);
    fs::create_directory(path);
}

void put_back(const fs::path& path, const std::string& text) {
    fs::remove_all(path);
    std::ofstream(path, std::ios::binary) << text;
}

TEST_CASE("what is no file at the name of one of results is named by each reader, with 3") {
    const Alarm alarm;
    const SmallFolder small;
    const std::string folder = small.folder.string(), page = (small.scratch / "page.html").string();
    const std::vector<std::vector<std::string>> commands = {
        {"table", folder, "--table", "errors"},
        {"report", folder, "-o", page},
        {"verify", folder, "--cells", "0"},
        {"diff", folder, folder},
        {"merge", folder, "-o", (small.scratch / "merged").string()}};
    for (const fs::path& file : small.files()) {
        const std::string text = contents(file);
        for (const bool is_pipe : {true, false}) {
            is_pipe ? make_pipe(file) : make_empty_folder(file);
            for (const std::vector<std::string>& words : commands) {
                const std::string name = file.filename().string();
                // Of a part only what its run has written is merged.
                const bool not_merged =
                    name.starts_with("results.") || name == "sums.sha256" || name == "geometry.json";
                const auto result = run_program(words);
                CAPTURE(file.string(), is_pipe, words.front(), result.messages);
                CHECK(result.code == (words.front() == "merge" && not_merged ? 0 : 3));
                if (result.code == 0) { continue; }
                CHECK_THAT(result.messages, Catch::Contains(name));
                CHECK_THAT(result.messages, Catch::Contains(is_pipe ? "got a named pipe" : "got a folder"));
            }
        }
        put_back(file, text);
    }
    for (const auto& words : commands) { CHECK(run_program(words).code == 0); }
}

TEST_CASE("links that lead in a circle are told in words of kreisel") {
    const SmallFolder small;
    const std::string folder = small.folder.string();
    for (const char* name : {"results.jsonl", "journal.jsonl", "manifest.json", "sums.sha256"}) {
        const fs::path file = small.folder / name;
        const std::string text = contents(file);
        fs::remove(file);
        fs::create_symlink(name, file);
        for (const std::vector<std::string>& words : {std::vector<std::string>{"table", folder, "--table", "errors"},
                                                      {"verify", folder, "--cells", "0"},
                                                      {"diff", folder, folder}}) {
            const auto result = run_program(words);
            CAPTURE(name, words.front(), result.messages);
            CHECK(result.code == 3);
            CHECK_THAT(result.messages, Catch::Contains(name) && !Catch::Contains("filesystem error"));
        }
        put_back(file, text);
    }
    fs::create_symlink("loop.json", small.scratch / "loop.json");
    const auto extends = run_program({"check", small.scratch.file("extends.json", R"({"extends": "loop.json"})")});
    CHECK(extends.code == 2);
    CHECK_THAT(extends.messages, Catch::Contains("which is no file"));
}

TEST_CASE("a resume refuses a journal that is no file, and does away with other names of its own") {
    const Alarm alarm;
    const SmallFolder small;
    const std::vector<std::string> resume = {"run", small.config, "-o", small.folder.string(), "--resume"};
    const std::string lines = contents(small.folder / "results.jsonl");
    for (const char* name : {"journal.jsonl", "results.jsonl", "results.csv", "manifest.json"}) {
        const std::string text = contents(small.folder / name);
        make_pipe(small.folder / name);
        const auto result = run_program(resume);
        CAPTURE(name, result.messages);
        const bool is_read = std::string(name) == "journal.jsonl";
        CHECK(result.code == (is_read ? 3 : 0));
        if (is_read) {
            CHECK_THAT(result.messages, Catch::Contains("journal.jsonl: expected a file, got a named pipe"));
            put_back(small.folder / name, text);
        }
        CHECK(contents(small.folder / "results.jsonl") == lines);
    }
}

TEST_CASE("configs, and files that they name, are refused with 2 where they are pipes; descriptors are read") {
    const Alarm alarm;
    const ScratchFolder scratch;
    make_pipe(scratch / "pipe.json");
    const std::string pipe = (scratch / "pipe.json").string();
    const auto config = [](const std::string& more) {
        return R"({"name": "n", "kind": "drift", "problems": ["heavy_top"], "methods": ["rkmk/rk4"], "time": )" + more +
               "}";
    };
    const std::string time = R"({"end": 1, "steps": 4})";
    const std::vector<std::string> refused = {
        pipe, scratch.file("extends.json", R"({"extends": "pipe.json"})"),
        scratch.file("begin.json", config(R"({"begin": {"file": "pipe.json"}, "end": 1, "steps": 4})")),
        scratch.file("overlay.json", config(time + R"(, "figure": {"kind": "drift",
            "overlay": [{"file": "pipe.json", "x": "a", "y": "b"}]})"))};
    for (const std::string& file : refused) {
        const auto result = run_program({"check", file});
        CAPTURE(file, result.messages);
        CHECK(result.code == 2);
        CHECK_THAT(result.messages, Catch::Contains("a named pipe"));
    }
    int ends[2] = {};
    REQUIRE(::pipe(ends) == 0);
    const std::string good = config(time);
    REQUIRE(::write(ends[1], good.data(), good.size()) == static_cast<ssize_t>(good.size()));
    ::close(ends[1]);
    const auto result = run_program({"check", "/dev/fd/" + std::to_string(ends[0])});
    CAPTURE(result.messages);
    CHECK(result.code == 0);
    ::close(ends[0]);
}

}  // namespace kreisel::no_file_tests
