// SPDX-License-Identifier: BSD-3-Clause
//
// A bad config never runs: exit 2 and a message with file, line, column, JSON pointer, what was expected and what was
// found.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "records/json/diagnostics.hpp"
#include "records/json/locator.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/config/bad_configs.hpp"

using namespace kreisel;

namespace {

// The line of the messages about `pointer`.
std::string message_at(const std::string& messages, const std::string& pointer) {
    std::istringstream lines(messages);
    for (std::string line; std::getline(lines, line);) {
        if (line.find(": " + pointer + ": ") != std::string::npos) { return line; }
    }
    return "";
}

std::string patched(const std::string& patch) {
    auto config = nlohmann::ordered_json::parse(good_config());
    config.merge_patch(nlohmann::ordered_json::parse(patch));
    return config.dump(2);
}

}  // namespace

TEST_CASE("the config that the bad ones are made from is good") {
    const ScratchFolder scratch;
    const auto result = run_program({"check", scratch.file("good.json", good_config())});
    CHECK(result.messages == "");
    CHECK(result.code == 0);
    CHECK(result.out.find("12 cells: 12 to run, 0 skipped; 1 reference solution") != std::string::npos);
}

TEST_CASE("each bad config is refused at its error") {
    const ScratchFolder scratch;
    REQUIRE(bad_configs().size() >= 60);
    for (const BadConfig& bad : bad_configs()) {
        const std::string text = patched(bad.patch);
        const std::string file = scratch.file("bad.json", text);
        const auto result = run_program({"run", file, "-o", (scratch / "out").string()});
        INFO(bad.patch << "\n" << result.messages);
        CHECK(result.code == 2);
        CHECK_FALSE(std::filesystem::exists(scratch / "out"));
        const std::string message = message_at(result.messages, bad.pointer);
        CHECK(message.find(bad.phrase) != std::string::npos);
        CHECK(message.find("expected ") != std::string::npos);
        CHECK(std::regex_search(message.substr(file.size()), std::regex("^:[0-9]+:[0-9]+: /")));
    }
}

TEST_CASE("text that is not JSON is refused at the error") {
    const ScratchFolder scratch;
    for (const BadConfig& bad : bad_texts()) {
        const std::string file = scratch.file("bad.json", bad.patch);
        const auto result = run_program({"check", file});
        INFO(bad.patch.substr(0, 100) << "\n" << result.messages);
        CHECK(result.code == 2);
        CHECK(result.messages.find(": " + bad.pointer) != std::string::npos);
        CHECK(result.messages.find(bad.phrase) != std::string::npos);
        CHECK(std::count(result.messages.begin(), result.messages.end(), '\n') == 1);
    }
}

TEST_CASE("files that cannot be configs at all") {
    const ScratchFolder scratch;
    const auto huge = run_program({"check", scratch.file("huge.json", "[" + std::string(9U << 20U, ' ') + "]")});
    CHECK(huge.code == 2);
    CHECK(huge.messages.find("at most 8 MB") != std::string::npos);
    CHECK(run_program({"check", (scratch / "absent.json").string()}).code == 3);
    CHECK(run_program({"check", (scratch / "").string()}).messages.find("got a folder") != std::string::npos);
}

TEST_CASE("all errors of a config are reported at once, in the order of the text") {
    const ScratchFolder scratch;
    const auto result = run_program(
        {"check", scratch.file("bad.json", patched(R"({"kind": "x", "time": {"end": -1}, "metrics": 1})"))});
    const auto kind = result.messages.find("/kind"), end = result.messages.find("/time/end"),
               metrics = result.messages.find("/metrics");
    CHECK(kind < end);
    CHECK(end < metrics);
    CHECK(metrics != std::string::npos);
}

TEST_CASE("values and keys are found in the text") {
    const std::string text = "{\n  \"a\": [1, {\"b\\u0063\": \"x]\"}],\n  \"\xC3\xA4\": 2, \"m~/\": {\"z\": [3]}\n}";
    const auto line_column = [&](const std::string& pointer, Target target = Target::value) {
        const Position position = position_of_byte(text, locate(text, pointer, target));
        return std::make_pair(position.line, position.column);
    };
    CHECK(line_column("") == std::make_pair(1L, 1L));
    CHECK(line_column("/a") == std::make_pair(2L, 8L));
    CHECK(line_column("/a", Target::key) == std::make_pair(2L, 3L));
    CHECK(line_column("/a/1/bc") == std::make_pair(2L, 24L));
    CHECK(line_column("/\xC3\xA4") == std::make_pair(3L, 8L));
    CHECK(line_column("/m~0~1/z/0") == std::make_pair(3L, 25L));
    CHECK(line_column("/m~0~1/absent/0") == std::make_pair(3L, 18L));
}

TEST_CASE("a long value is cut between characters") {
    std::string text;
    for (int i = 0; i < 20; ++i) { text += "ä"; }
    CHECK(in_quotes("x" + text + text) == "\"x" + text + "äääääääää...\"");
    CHECK(in_quotes(text) == "\"" + text + "\"");
}
