// SPDX-License-Identifier: BSD-3-Clause
//
// Tableaus in a config, through the whole program: they run beside the methods that have them built in, are told apart
// in results, and do not run where they are wrong.
#include <catch2/catch.hpp>

#include "records/reading/read_results.hpp"
#include "records/results.hpp"
#include "support/files.hpp"
#include "tests/campaign/program.hpp"

using namespace kreisel;
using namespace kreisel::acceptance;

namespace {

const std::string classical = R"({"name": "rkmk/tableau", "label": "classical", "a": [["1/2"], [0, "0.5"], [0, 0, 1]],
    "b": ["1/6", "1/3", "1/3", "1/6"], "c": [0, "1/2", "1/2", 1], "order": 4})";
const std::string bogacki_shampine = R"({"name": "rkmk/tableau", "label": "pair", "a": "1/2; 0 3/4; 2/9 1/3 4/9",
    "b": "2/9 1/3 4/9 0", "b_hat": "7/24 1/4 1/3 1/8", "order": 3, "order_hat": 2})";

std::string config_with(const std::string& methods) {
    return R"({"name": "own", "kind": "convergence", "precision": ["double", "quad"], "problems": ["heavy_top"],
        "formulations": ["SO3xR3", "SE3", "SO3", "S3xR3", "S3"], "methods": [)" +
           methods + R"(], "time": {"end": 0.0625, "steps": [64, 128], "tolerance": [1e-3, 1e-4]}})";
}

/// The row of the same cell but for its method; of a written one, by its label.
const ResultRow* twin(const Results& results, const ResultRow& row, const std::string& method) {
    for (const ResultRow& other : results.rows)
        if (other.method == method && other.formulation == row.formulation && other.precision == row.precision &&
            other.steps == row.steps && other.tolerance == row.tolerance)
            return &other;
    return nullptr;
}

}  // namespace

TEST_CASE("written tableaus have the results of built-in ones, in every formulation and precision", "[campaign]") {
    const Folder folder;
    const auto config =
        folder.file("own.json", config_with(R"("rkmk/rk4", "rkmk/bs3", )" + classical + ", " + bogacki_shampine));
    const std::string out = (folder.path / "out").string();
    const Said said = kreisel_with({"run", config, "-o", out});
    INFO(said.messages);
    REQUIRE(said.code == 0);
    const Results results = read_results(out);
    std::size_t compared = 0;
    for (const ResultRow& row : results.rows) {
        if (row.method != "rkmk/tableau") continue;
        const bool pair = row.options->at("label") == "pair";
        const ResultRow* other = twin(results, row, pair ? "rkmk/bs3" : "rkmk/rk4");
        INFO(row.options->at("label") << row.formulation << row.precision << row.steps << row.tolerance);
        CHECK(row.declared_order->at("error.position") == (pair ? 3 : 4));
        CHECK(row.ok());
        CHECK(row.adaptive() <= pair);
        REQUIRE(other != nullptr);
        CHECK(row.cell != other->cell);
        CHECK(row.metrics == other->metrics);
        ++compared;
    }
    CHECK(compared == 5 * 2 * (2 + 4));
    CHECK(kreisel_with({"verify", out}).code == 0);
    CHECK_THAT(kreisel_with({"table", out}).out,
               Catch::Contains("rkmk/tableau classical") && Catch::Contains("rkmk/tableau pair"));
}

TEST_CASE("a tableau without its declared order is an error of the config", "[campaign]") {
    const Folder folder;
    std::string fifth = classical;
    fifth.replace(fifth.find("\"order\": 4"), 10, "\"order\": 5");
    const Said said = kreisel_with({"check", folder.file("own.json", config_with(fifth))});
    CHECK(said.code == 2);
    CHECK_THAT(said.messages, Catch::Contains(": /methods/0/order: ") && Catch::Contains("tree [t t t t]"));
    std::string misprint = classical;
    misprint.replace(misprint.find("\"0.5\""), 5, "\"0.6\"");
    CHECK_THAT(kreisel_with({"check", folder.file("own.json", config_with(misprint))}).messages,
               Catch::Contains("/methods/0/c") && Catch::Contains("for row 3, which sums to 3/5"));
}
