// SPDX-License-Identifier: BSD-3-Clause
//
// The sources of what a config uses, as BibTeX.
#include <algorithm>
#include <catch2/catch.hpp>
#include <stdexcept>

#include "driver/cli/cite/bibliography.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/other_engine.hpp"

using namespace kreisel;

namespace {

std::string config_with(const std::string& problem, const std::string& method) {
    return R"({"name": "some", "kind": "convergence", "problems": [")" + problem + R"("], "methods": [")" + method +
           R"("], "time": {"end": 1.0, "steps": 8}})";
}

std::vector<std::string> keys_of(const std::vector<BibliographyEntry>& entries) {
    std::vector<std::string> keys;
    for (const BibliographyEntry& entry : entries) { keys.push_back(entry.key); }
    return keys;
}

}  // namespace

TEST_CASE("entries of a bibliography are found with their braces, and nothing between them") {
    const auto entries = bibliography_entries(
        "% a@b\n@article{one, title = {A {Lie} group}, note = {see \\cite{two, three}}}\nloose {text}\n"
        "@misc{ two ,\n}\n");
    REQUIRE(keys_of(entries) == std::vector<std::string>{"one", "two"});
    CHECK(entries[0].text == "@article{one, title = {A {Lie} group}, note = {see \\cite{two, three}}}");
    CHECK(keys_cited_in(entries[0]) == std::vector<std::string>{"two", "three"});
    CHECK(keys_cited_in(entries[1]).empty());
    CHECK_THROWS_WITH(bibliography_entries("@article{one, title = {never ends}\n"), Catch::Contains("\"one\""));
}

TEST_CASE("the program has the bibliography of the paper") {
    const auto keys = keys_of(bibliography());
    CHECK(keys.size() > 50);
    CHECK(std::find(keys.begin(), keys.end(), "terzezlatarmueller") != keys.end());
}

TEST_CASE("cite prints the entries of a config, and names what has none") {
    const ScratchFolder scratch;
    const auto cited = run_program({"cite", scratch.file("some.json", config_with("free_top", "rkmk/rk4"))});
    INFO(cited.messages);
    CHECK(cited.code == 0);
    CHECK_THAT(cited.out, Catch::StartsWith("% rkmk/rk4\n@article{kutta1901,"));
    CHECK_THAT(cited.out, Catch::EndsWith("}\n\n"));
    CHECK(keys_of(bibliography_entries(cited.out)) == std::vector<std::string>{"kutta1901"});
    CHECK(cited.messages == "without a source: free_top, none, SO3xR3\n");
}

TEST_CASE("cite prints the sources of formulations") {
    class CitingEngine final : public OtherEngine {
        std::vector<FormulationDescription> formulations() const override {
            return {{"SO3xR3", "direct product", {"muellerterze2014"}}};
        }
    };
    const ScratchFolder scratch;
    const auto cited =
        run_program({"cite", scratch.file("some.json", config_with("free_top", "rkmk/rk4"))}, CitingEngine());
    CHECK(cited.code == 0);
    CHECK(keys_of(bibliography_entries(cited.out)) == std::vector<std::string>{"kutta1901", "muellerterze2014"});
    CHECK_THAT(cited.messages, !Catch::Contains("SO3xR3"));
}

TEST_CASE("what an entry cites is printed too") {
    class CitingEngine final : public OtherEngine {
        std::vector<MethodDescription> methods() const override {
            return {{"rkmk/rk4", 4, {"terzezlatarmueller"}, "classical", 4}};
        }
    };
    const ScratchFolder scratch;
    const auto cited =
        run_program({"cite", scratch.file("some.json", config_with("free_top", "rkmk/rk4"))}, CitingEngine());
    CHECK(keys_of(bibliography_entries(cited.out)) == std::vector<std::string>{"terzezlatarmueller", "terze2015"});
    CHECK_THAT(cited.out, Catch::Contains("% terzezlatarmueller\n@article{terze2015,"));
}

TEST_CASE("a key that is not in the bibliography, or a config that cannot be read, is an error") {
    const ScratchFolder scratch;
    const auto cited = run_program({"cite", scratch.file("some.json", config_with("heavy_top", "rkmk/rk4"))});
    CHECK(cited.code == 4);
    CHECK_THAT(cited.messages, Catch::Contains("heavy_top cites \"source2000\""));
    CHECK(run_program({"cite", scratch.file("other.json", config_with("heavy_top", "rkmk/rk5"))}).code == 2);
    CHECK(run_program({"cite", "/absent.json"}).code == 3);
}
