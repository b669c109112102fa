// SPDX-License-Identifier: BSD-3-Clause
//
// The cache of references: shared between result folders, verified when read, never required.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <optional>

#include "records/reference_store.hpp"
#include "support/hash.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;

namespace {

/// Sets a variable of the environment (nothing: removes it) for as long as it lives.
class Variable {
  public:
    Variable(const char* name, const std::optional<std::string>& value) : name_(name) {
        if (const char* old = std::getenv(name)) { old_ = old; }
        set(value);
    }
    ~Variable() { set(old_); }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;

  private:
    void set(const std::optional<std::string>& value) const {
        value ? ::setenv(name_, value->c_str(), 1) : ::unsetenv(name_);
    }
    const char* name_;
    std::optional<std::string> old_;
};

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) { files.push_back(entry.path()); }
    return files;
}

/// Two configs that differ only in their methods share their reference.
struct Fixture {
    ScratchFolder scratch;
    Variable cache{"KREISEL_CACHE", (scratch / "cache").string()};
    std::string config = scratch.file("good.json", good_config());
    FakeEngine engine;

    ProgramResult run(const std::string& folder) {
        return run_program({"run", config, "-o", (scratch / folder).string()}, engine);
    }
    std::filesystem::path entry() const {
        const auto files = files_in(scratch / "cache" / "references");
        REQUIRE(files.size() == 1);
        return files.front();
    }
};

}  // namespace

TEST_CASE("a reference is computed once for all result folders, each of which keeps a copy") {
    Fixture f;
    REQUIRE(f.run("a").code == 0);
    CHECK(f.engine.references == 1);
    REQUIRE(f.run("b").code == 0);
    CHECK(f.engine.references == 1);
    const auto copy = files_in(f.scratch / "b" / "references");
    REQUIRE(copy.size() == 1);
    CHECK(contents(copy.front()) == contents(f.entry()));
    CHECK(contents(f.scratch / "a" / "results.jsonl") == contents(f.scratch / "b" / "results.jsonl"));
    std::filesystem::remove_all(f.scratch / "cache");
    REQUIRE(run_program({"run", f.config, "-o", (f.scratch / "b").string(), "--resume"}, f.engine).code == 0);
    CHECK(f.engine.references == 1);
}

TEST_CASE("a reference without samples does not serve where they are needed, and stays beside the new one") {
    Fixture f;
    REQUIRE(f.run("a").code == 0);
    std::string sampled = good_config();
    sampled.insert(sampled.rfind('}'), R"(, "output": {"samples": 4})");
    f.config = f.scratch.file("sampled.json", sampled);
    REQUIRE(f.run("b").code == 0);
    REQUIRE(f.run("c").code == 0);
    CHECK(f.engine.references == 2);
    CHECK(files_in(f.scratch / "cache" / "references").size() == 2);
    CHECK(contents(f.scratch / "b" / "results.jsonl").find("error.position.max") != std::string::npos);
    const std::string folder = (f.scratch / "c").string();
    CHECK(run_program({"verify", folder, "--cells", "1"}, f.engine).code == 0);
    const auto file = files_in(f.scratch / "c" / "references").front();
    std::string text = contents(file);  // the first state is that of the end, the second that of the first sample
    const auto digit = text.find("\"x\":[\"0.", text.find("\"samples\"", text.find("\"state\""))) + 8;
    text[digit] = text[digit] == '1' ? '2' : '1';
    text.resize(text.rfind(",\"sum\":"));
    std::ofstream(file) << text << ",\"sum\":\"" << hash_text(text) << "\"}\n";
    const auto bad = run_program({"verify", folder, "--cells", "1"}, f.engine);
    CHECK(bad.code == 1);
    CHECK_THAT(bad.out, Catch::Contains("at the sample of 0.25 s error.position is off by"));
}

TEST_CASE("a reference computed by other code is computed again, and both stay in the cache") {
    Fixture f;
    REQUIRE(f.run("a").code == 0);
    f.engine.digest = "changed";
    REQUIRE(f.run("b").code == 0);
    CHECK(f.engine.references == 2);
    CHECK(files_in(f.scratch / "cache" / "references").size() == 2);
    REQUIRE(f.run("c").code == 0);
    CHECK(f.engine.references == 2);
}

TEST_CASE("a damaged entry of the cache is recognised, computed again and written over") {
    Fixture f;
    REQUIRE(f.run("a").code == 0);
    const std::string good = contents(f.entry());
    const auto position = good.find("\"horizon\":") + 10;
    std::string changed = good;
    changed[position] = '7';
    for (const std::string& text : {changed, good.substr(0, good.size() / 2), std::string()}) {
        std::ofstream(f.entry()) << text;
        const int before = f.engine.references;
        REQUIRE(f.run("b" + std::to_string(before)).code == 0);
        CHECK(f.engine.references == before + 1);
        CHECK(contents(f.entry()).size() == good.size());
    }
    CHECK(f.run("c").code == 0);
    CHECK(f.engine.references == 4);
}

TEST_CASE("a cache that cannot be written is noted, and the run goes on") {
    Fixture f;
    f.scratch.file("cache", "a file in the way");
    const auto result = f.run("a");
    CHECK(result.code == 0);
    CHECK(result.messages.find("note: references are kept in the results only") != std::string::npos);
    CHECK(result.messages.find("cache") != std::string::npos);
    CHECK(files_in(f.scratch / "a" / "references").size() == 1);
}

TEST_CASE("a cache entry that is not a file does not stop the run") {
    Fixture f;
    REQUIRE(f.run("a").code == 0);
    const auto entry = f.entry();
    std::filesystem::remove(entry);
    std::filesystem::create_directories(entry / "below");
    const auto result = f.run("b");
    CHECK(result.code == 0);
    CHECK(f.engine.references == 2);
    CHECK(result.messages.find("note:") != std::string::npos);
}

TEST_CASE("the environment sets the place of the cache, or disables it") {
    const Variable own("KREISEL_CACHE", std::nullopt);
    const Variable home("HOME", "/absent/place");
    const Variable base("XDG_CACHE_HOME", "/var/somewhere");
    CHECK(default_cache_folder() == "/var/somewhere/kreisel");
    const Variable relative("XDG_CACHE_HOME", "relative");
    CHECK(default_cache_folder() == "/absent/place/.cache/kreisel");
    const Variable homeless("HOME", std::nullopt);
    CHECK(default_cache_folder().empty());
    const Variable chosen("KREISEL_CACHE", "here");
    CHECK(default_cache_folder() == "here");
    const Variable none("KREISEL_CACHE", "");
    CHECK(default_cache_folder().empty());
}

TEST_CASE("verify compares the stored references with the second route") {
    Fixture f;
    REQUIRE(f.run("a").code == 0);
    const std::vector<std::string> verify = {"verify", (f.scratch / "a").string(), "--cells", "1"};
    const auto good = run_program(verify, f.engine);
    CHECK(good.code == 0);
    CHECK(good.out.find("1 of 1 references confirmed by the second route, 0 wrong or missing") != std::string::npos);
    const auto file = files_in(f.scratch / "a" / "references").front();
    CHECK(good.out.find("1 of 1 references computed again, 0 differ") != std::string::npos);
    std::string text = contents(file);
    const auto write = [&] {  // with a valid check sum
        text.resize(text.rfind(",\"sum\":"));
        std::ofstream(file) << text << ",\"sum\":\"" << hash_text(text) << "\"}\n";
    };

    SECTION("a digit changed") {
        const auto digit = text.find("\"x\":[\"0.") + 8;
        text[digit] = text[digit] == '1' ? '2' : '1';
        write();
        const auto bad = run_program(verify, f.engine);
        CHECK(bad.code == 1);
        CHECK(bad.out.find("error.position is off by") != std::string::npos);
    }
    SECTION("its bound changed, within what the second route can tell") {
        const std::string bound = "\"error.position\":\"1e-20\"";
        text.replace(text.find(bound), bound.size(), "\"error.position\":\"1e-19\"");
        write();
        const auto bad = run_program(verify, f.engine);
        CHECK(bad.code == 1);
        CHECK(bad.out.find("comes out different") != std::string::npos);
        CHECK(bad.out.find("1 of 1 references computed again, 1 differ") != std::string::npos);
        f.engine.digest = "other code";
        const auto other = run_program(verify, f.engine);
        CHECK(other.out.find("0 of 1 references computed again, 0 differ") != std::string::npos);
    }
    SECTION("damaged") {
        std::ofstream(file) << text.substr(0, 100);
        const auto bad = run_program(verify, f.engine);
        CHECK(bad.code == 3);
        CHECK(bad.messages.find(file.string() + ":1: damaged: its sum does not hold") != std::string::npos);
        CHECK(bad.out.find("missing or damaged") != std::string::npos);
    }
}
