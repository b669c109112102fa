// SPDX-License-Identifier: BSD-3-Clause
//
// What registers itself fits together: kinds of experiments, kinds of figures, tables.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <set>

#include "plots/figures/gnuplot.hpp"
#include "plots/figures/kind.hpp"
#include "plots/tables/table.hpp"
#include "records/json/strict.hpp"
#include "records/kinds/kind.hpp"

using namespace kreisel;

TEST_CASE("a kind of experiments has a figure that can draw it") {
    REQUIRE(experiment_kinds().size() >= 4);
    for (const ExperimentKind& kind : experiment_kinds()) {
        INFO(kind.name);
        const FigureKind* figure = find_figure_kind(kind.figure);
        REQUIRE(figure != nullptr);
        CHECK((figure->draws == FigureData::timed_cells) == kind.timed);
        CHECK((!kind.timed || kind.metrics.empty()));  // other measurements would be timed with the steps
    }
    CHECK(find_experiment_kind("pie") == nullptr);
}

TEST_CASE("a kind of figures has a script, keys of its own, and defaults that its keys read") {
    REQUIRE(figure_kinds().size() >= 7);
    for (const FigureKind& kind : figure_kinds()) {
        INFO(kind.name);
        CHECK(std::filesystem::exists(plot_scripts() / (kind.script + ".gp")));
        CHECK((kind.otherwise.empty() || find_figure_kind(kind.otherwise) != nullptr));
        std::set<std::string> names = {"kind"};
        const auto standard = kind.make();
        for (const auto& keys : {common_figure_keys(), kind.keys}) {
            for (const FigureKey& key : keys) {
                INFO(key.name);
                CHECK(names.insert(key.name).second);
                const auto value = key.value(*standard);
                if (value.is_null()) { continue; }
                const Document document = parse_document("test.json", value.dump());
                Diagnostics diagnostics(document);
                const auto read = kind.make();
                key.read(Node(document.value, "", diagnostics), *read);
                CHECK(diagnostics.empty());
                CHECK(key.value(*read) == value);
            }
        }
        CHECK((names.contains("width") && names.contains("font_size")));  // every figure must fit a page
    }
}

TEST_CASE("tables have names and places of their own") {
    REQUIRE(result_tables().size() >= 10);
    std::set<std::string> names;
    std::set<int> places;
    for (const ResultTable& table : result_tables()) {
        INFO(table.name);
        CHECK(names.insert(table.name).second);
        CHECK(places.insert(table.place).second);
        CHECK_FALSE(table.summary.empty());
    }
}

TEST_CASE("energy over long times is printed where neither errors nor the geometry of steps are in question") {
    const auto& all = result_tables();
    const auto table =
        std::find_if(all.begin(), all.end(), [](const ResultTable& one) { return one.name == "energy"; });
    REQUIRE(table != all.end());
    const auto printed_with = [&](const std::string& metric) {
        Results results;
        results.rows.emplace_back().metrics = {{"invariant.energy", 1e-3}, {metric, 1e-3}};
        return table->is_printed(results);
    };
    CHECK(printed_with("defect.position"));
    CHECK_FALSE(printed_with("error.position"));
    CHECK_FALSE(printed_with("structure.symplectic"));
}
