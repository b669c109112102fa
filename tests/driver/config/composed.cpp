// SPDX-License-Identifier: BSD-3-Clause
//
// Configs that extend others, settings and filters of the command line, and where messages about them point.
#include "driver/config/composition/composed.hpp"

#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "support/errors.hpp"
#include "tests/driver/command_line.hpp"

using namespace kreisel;
using Catch::Contains;
using nlohmann::json;

namespace {

ProgramResult plan_json(std::vector<std::string> words) {
    words.insert(words.begin(), "plan");
    words.emplace_back("--json");
    return run_program(words);
}

std::size_t cells_of(const std::vector<std::string>& words) {
    const ProgramResult result = plan_json(words);
    INFO(result.messages);
    REQUIRE(result.code == 0);
    return json::parse(result.out).at("cells").size();
}

/// What --set is refused with.
std::string refusal(const std::string& setting) {
    ScratchFolder scratch;
    const ProgramResult result = run_program({"check", scratch.file("good.json", good_config()), "--set", setting});
    CHECK(result.code == 2);
    return result.messages;
}

}  // namespace

TEST_CASE("a config that extends another is its merge patch, relative to its own folder") {
    ScratchFolder scratch;
    std::filesystem::create_directory(scratch / "more");
    scratch.file("good.json", good_config());
    scratch.file("middle.json", R"({"extends": "good.json", "projections": null, "time": {"end": 2.0}})");
    const std::string last = scratch.file("more/last.json", R"({"extends": "../middle.json", "name": "last",
        "methods": ["rkmk/rk4"]})");
    const Document whole = composed_config(last);
    json expected = json::parse(good_config());
    expected.erase("projections");
    expected["time"]["end"] = 2.0;
    expected["name"] = "last";
    expected["methods"] = {"rkmk/rk4"};
    CHECK(whole.value == expected);
    CHECK(json::parse(whole.text) == expected);
    CHECK(whole.file == last);
}

TEST_CASE("a config that extends nothing is read as it stands") {
    ScratchFolder scratch;
    const Document whole = composed_config(scratch.file("good.json", good_config()));
    CHECK(whole.text == good_config());
    CHECK(whole.layers.empty());
}

TEST_CASE("a config is read from a pipe too") {
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    const std::string text = good_config();
    REQUIRE(::write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size()));
    ::close(ends[1]);
    const Document read = composed_config("/dev/fd/" + std::to_string(ends[0]));
    ::close(ends[0]);
    CHECK(read.value == nlohmann::json::parse(text));
}

TEST_CASE("configs that lead back to themselves, or to no file, are refused") {
    ScratchFolder scratch;
    const std::string a = scratch.file("a.json", R"({"extends": "b.json"})");
    const std::string b = scratch.file("b.json", "{\n  \"extends\": \"./a.json\"\n}");
    CHECK_THROWS_WITH(composed_config(a), Contains("b.json:2:14: /extends: expected a config that does not lead back"));
    const std::string own = scratch.file("own.json", R"({"extends": "own.json"})");
    CHECK_THROWS_WITH(composed_config(own), Contains("own.json:1:13: /extends"));
    const std::string lost = scratch.file("lost.json", R"({"extends": "nowhere.json"})");
    CHECK_THROWS_WITH(composed_config(lost), Contains("\"nowhere.json\", which is no file"));
    const std::string folder = scratch.file("folder.json", R"({"extends": "."})");
    CHECK_THROWS_WITH(composed_config(folder), Contains("folder.json:1:13: /extends") && Contains("which is a folder"));
    const std::string number = scratch.file("number.json", R"({"extends": 3})");
    CHECK_THROWS_WITH(composed_config(number), Contains("expected the path of a config") && Contains("got 3"));
}

TEST_CASE("an error in a config made of others points into the file or setting that wrote it") {
    ScratchFolder scratch;
    scratch.file("base.json",
                 "{\"name\": \"n\", \"kind\": \"convergence\", \"problems\": [\"heavy_top\"],\n"
                 "\"time\": {\"end\": 1,\n \"steps\": -8}}");
    const std::string last = scratch.file("last.json", "{\"extends\": \"base.json\",\n\"methods\": [\"rkmk/rk5\"]}");
    const ProgramResult result = run_program({"check", last, "--set", "/time/end=-1", "--set", "/kind=convergense"});
    CHECK(result.code == 2);
    CHECK_THAT(result.messages, Contains("base.json:3:11: /time/steps: expected"));
    CHECK_THAT(result.messages, Contains("last.json:2:13: /methods/0: expected"));
    CHECK_THAT(result.messages, Contains("--set /time/end=-1:1:1: /time/end: expected"));
    CHECK_THAT(result.messages, Contains("did you mean \"convergence\"?"));
}

TEST_CASE("a setting replaces one value, in every command that reads a config") {
    ScratchFolder scratch;
    const std::string good = scratch.file("good.json", good_config());
    CHECK(cells_of({good}) == 12);
    CHECK(cells_of({good, "--set", "/methods=[\"rkmk/rk4\"]"}) == 4);
    CHECK(cells_of({good, "--set", "/time/steps/levels=3", "--set", "/projections=[\"none\"]"}) == 9);
    const auto folder = scratch / "out";
    REQUIRE(run_program({"run", good, "-o", folder.string(), "--set", "/time/end=0.5"}).code == 0);
    CHECK(json::parse(contents(folder / "manifest.json"))["config"]["time"]["end"] == 0.5);
    CHECK(run_program({"check", good, "--set", "/output/samples=4"}).code == 0);  // a key that was not there
}

TEST_CASE("a setting without a place is refused") {
    CHECK_THAT(refusal("time.end=2"), Contains("expected /POINTER=VALUE"));
    CHECK_THAT(refusal("/time/end"), Contains("expected /POINTER=VALUE"));
    CHECK_THAT(refusal("=2"), Contains("expected /POINTER=VALUE"));
    CHECK_THAT(refusal("/methods/2=rkmk/rk4"), Contains("expected an index below 2 or -, got \"2\""));
    CHECK_THAT(refusal("/methods/one=rkmk/rk4"), Contains("expected an index below 2 or -"));
    CHECK_THAT(refusal("/name/first=x"), Contains("expected a list or an object above \"first\""));
    CHECK_THAT(refusal("/tome/end=2"), Contains("did you mean \"time\"?"));
    CHECK_THAT(refusal("/time={\"end\": 1, \"end\": 2}"), Contains("/end"));
}

TEST_CASE("filters leave what fits on an axis") {
    ScratchFolder scratch;
    const std::string good = scratch.file("good.json", good_config());
    CHECK(cells_of({good, "--filter", "methods=*/midpoint"}) == 4);
    CHECK(cells_of({good, "--filter", "methods=rkmk/rk4,rkmk/mid*", "--filter", "projections=none"}) == 6);
    CHECK(cells_of({good, "--filter", "problems=heavy*", "--filter", "precision=double"}) == 12);
    const auto refused = [&](const std::string& filter) {
        const ProgramResult result = run_program({"plan", good, "--filter", filter});
        CHECK(result.code == 2);
        return result.messages;
    };
    CHECK_THAT(refused("methods=rkmk/rk5"), Contains("nothing fits") && Contains("did you mean \"rkmk/rk4\"?"));
    CHECK_THAT(refused("method=rkmk/rk4"), Contains("did you mean \"methods\"?"));
    CHECK_THAT(refused("methods="), Contains("expected AXIS=PATTERN"));
    CHECK_THAT(refused("methods"), Contains("expected AXIS=PATTERN"));
    CHECK_THAT(refused("methods"), !Contains("did you mean"));
}
