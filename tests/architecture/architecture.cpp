// SPDX-License-Identifier: BSD-3-Clause
//
// Checks the folders and their arrows against the sources. Every rule is also tried on a small
// tree that breaks only this rule, so that a rule that no longer works is noticed.
#include <catch2/catch.hpp>

#include <algorithm>
#include <map>

#include "kreisel_build.hpp"
#include "tests/architecture/rules.hpp"

namespace {

namespace fs = std::filesystem;
using namespace architecture;

const fs::path project_root = kreisel::build::source_dir;

std::string print(const std::vector<Finding>& findings) {
    std::string lines;
    for (const auto& finding : findings) { lines += to_string(finding) + "\n"; }
    return lines;
}

}  // namespace

TEST_CASE("the sources follow the architecture", "[architecture]") {
    const auto& root = project_root;
    const auto tree = load_tree(root);
    const auto bibliography = bibliography_keys(read_text(root / "paper/references.bib"));
    for (const auto* folder : {"support", "lie", "mechanics", "problems", "methods", "peers", "engine", "records",
                               "plots", "driver", "tests"}) {
        const bool found =
            std::any_of(tree.begin(), tree.end(), [&](const Source& s) { return s.is_cpp() && s.folder() == folder; });
        INFO("no C++ file found in " << folder << ": the test looks in the wrong place");
        REQUIRE(found);
    }
    const auto findings = print(check_all(tree, bibliography));
    INFO(findings);
    CHECK(findings.empty());
}

TEST_CASE("each rule catches the tree that breaks it", "[architecture]") {
    const std::map<std::string, std::string> expected = {{"arrow_own", "lie/group.hpp:3: arrow"},
                                                         {"arrow_library", "methods/euler.cpp:3: arrow"},
                                                         {"arrow_gsl", "problems/free_top.cpp:2: arrow"},
                                                         {"arrow_terminal", "mechanics/system.cpp:2: arrow"},
                                                         {"arrow_upward", "records/journal.cpp:2: arrow"},
                                                         {"arrow_solve", "mechanics/joints/rows.cpp:2: arrow"},
                                                         {"full", "lie:1: full: 21 sources"},
                                                         {"arrow_inner", "plots/figures/spec.hpp:3: arrow"},
                                                         {"arrow_interface", "records/fits/order.cpp:2: arrow"},
                                                         {"arrow_cli", "driver/plan/plan.cpp:3: arrow"},
                                                         {"header_shared", "driver/cli/options.cpp:1: header"},
                                                         {"room_none", "experiments/run.cpp:1: room"},
                                                         {"arrow_missing", "methods/euler.cpp:2: arrow"},
                                                         {"licence_none", "plots/path.gp:1: licence"},
                                                         {"licence_late", "tools/tidy:1: licence"},
                                                         {"licence_python", "python/kreisel/results.py:1: licence"},
                                                         {"licence_gsl", "tests/oracle.cpp:1: licence"},
                                                         {"literal_tenth", "methods/ab.cpp:4: literal"},
                                                         {"literal_suffix", "lie/so3.cpp:2: literal"},
                                                         {"literal_exponent", "mechanics/kkt.cpp:3: literal"},
                                                         {"qualified", "lie/so3.cpp:4: qualified"},
                                                         {"precision", "methods/euler.cpp:3: precision"},
                                                         {"cite_list", "methods/euler.cpp:2: cite: unknown"},
                                                         {"cite_comment", "lie/so3.hpp:2: cite: nobody1999"},
                                                         {"class_twice", "methods/predictor.cpp:9: class"},
                                                         {"class_across", "records/predictor.hpp:6: class"},
                                                         {"kind_asked", "plots/plot.cpp:3: kind"},
                                                         {"kind_of_table", "plots/tables/energy.cpp:4: kind"},
                                                         {"nothing", ""}};
    const auto bad = project_root / "tests/architecture/bad";
    std::size_t cases = 0;
    for (const auto& entry : fs::directory_iterator(bad)) {
        const auto name = entry.path().filename().string();
        INFO(name);
        REQUIRE(expected.count(name) == 1);
        const auto findings = check_all(load_tree(entry.path()), {"known1900"});
        INFO(print(findings));
        ++cases;
        if (expected.at(name).empty()) {
            CHECK(findings.empty());
        } else {
            REQUIRE(findings.size() == 1);
            CHECK_THAT(to_string(findings[0]), Catch::StartsWith(expected.at(name)));
        }
    }
    CHECK(cases == expected.size());
}

TEST_CASE("a literal is dyadic where it is k / 2^n", "[architecture]") {
    for (const auto* yes :
         {"0.5", "1.0", "2.", ".25", "1e3", "2.5e-1", "0.000", "1'024.5", "9007199254740991.0", "1e15"}) {
        INFO(yes);
        CHECK(is_dyadic(yes));
    }
    for (const auto* no : {"0.1", "1e-3", "0.3", "1e23", "3.14159", "9007199254740993.0", "2.5e-3", "1e300"}) {
        INFO(no);
        CHECK_FALSE(is_dyadic(no));
    }
}

TEST_CASE("a bibliography with a key twice is refused", "[architecture]") {
    CHECK(bibliography_keys("@book{a2000,\n}\n@article{b2001, title = {@c{x,}}}").size() == 2);
    CHECK_THROWS_WITH(bibliography_keys("@book{a,\n}\n@misc{a,\n}"), Catch::Contains("twice"));
}
