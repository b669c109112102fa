// SPDX-License-Identifier: BSD-3-Clause
//
// What the rows of a run take in memory.
#include <malloc.h>

#include <catch2/catch.hpp>

#include "records/reading/read_results.hpp"
#include "records/results.hpp"
#include "tests/plots/folder.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace rows_in_memory {

namespace {

constexpr std::size_t count = 1000;

std::size_t bytes_in_use() {
    const auto info = ::mallinfo2();
    return info.uordblks + info.hblkhd;
}

// Of a cell as usual: a dozen metrics, an error with its reference, five parameters, one of which varies.
nlohmann::json line_of(std::size_t i) {
    char cell[17];
    std::snprintf(cell, sizeof cell, "%016zx", i);
    nlohmann::json metrics = {{"error.position", 1e-3}, {"error.rotation", 1e-3}, {"error.velocity", 1e-3}};
    for (const char* name : {"position", "velocity", "acceleration", "orthogonality"}) {
        metrics["defect." + std::string(name)] = metrics["defect." + std::string(name) + ".final"] = 1e-9;
    }
    const nlohmann::json parameters = {{"gravity", {0, 0, -9.81}},
                                       {"inertia", {{0.25, 0, 0}, {0, 0.5, 0}, {0, 0, 0.25}}},
                                       {"lever", {0, 1, 0}},
                                       {"mass", i % 100 + 1},
                                       {"omega", {0, 150, -4.61538}}};
    return result_line(cell, 4L << (i / 100), 1e-3,
                       {{"label", "heavy_top, mass = " + std::to_string(i % 100 + 1)},
                        {"series", "heavy_top"},
                        {"method", "commutator_free/cf4"},
                        {"options", {{"coordinates", "exp"}, {"dexpinv", "exact"}}},
                        {"parameters", parameters},
                        {"metrics", metrics}});
}

}  // namespace

TEST_CASE("a row of results takes at most 1.2 kB, with what it shares", "[rows]") {
    const ResultFolder folder;
    std::string lines;
    for (std::size_t i = 0; i < count; ++i) { lines += line_of(i).dump() + "\n"; }
    folder.write("results.jsonl", lines);
    const std::size_t before = bytes_in_use();
    const Results results = read_results(folder.path());
    const std::size_t shared = bytes_in_use() - before;
    REQUIRE(results.damage.empty());
    REQUIRE(results.rows.size() == count);
    CHECK(shared < 1200 * count);
    CHECK(&*results.rows[0].options == &*results.rows[count - 1].options);
    CHECK(&*results.rows[7].parameters == &*results.rows[107].parameters);
    CHECK(*results.rows[7].parameters != *results.rows[8].parameters);
    CHECK(results.rows[7].cost.begin()->first.data() == results.rows[8].cost.begin()->first.data());

    const std::size_t again = bytes_in_use();
    std::vector<ResultRow> apart;  // as they are before they share anything
    for (std::size_t i = 0; i < count; ++i) { apart.push_back(read_result_line(line_of(i).dump())); }
    CHECK(bytes_in_use() - again > 3 * shared);
}

}  // namespace rows_in_memory
