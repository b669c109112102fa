// SPDX-License-Identifier: BSD-3-Clause
//
// What methods preserve, from results with known answers: the law of a defect, the table, the figure's legend.
#include "plots/laws/structure.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "records/cell/line.hpp"
#include "tests/plots/folder.hpp"
#include "tests/plots/named_tables.hpp"

using namespace kreisel;
using namespace kreisel::test;

namespace {

// Cells of N = 64, 128, ... whose defect is coefficient h^order; absent where it is below ten times the uncertainty.
std::vector<ResultRow> structure_rows(double coefficient, double order, double uncertainty, int levels = 4) {
    std::vector<ResultRow> rows;
    for (int k = 0; k < levels; ++k) {
        const long steps = 64L << k;
        const double value = coefficient * std::pow(static_cast<double>(steps), -order);
        nlohmann::json metrics = {{"structure.symplectic.uncertainty", uncertainty}};
        if (value > 10 * uncertainty) { metrics["structure.symplectic"] = value; }
        ResultRow row = read_result_line(result_line("aa", steps, 1e-6, {{"metrics", metrics}}).dump());
        row.metrics.erase("error.position");
        rows.push_back(row);
    }
    return rows;
}

StructureLaw structure_law_of(const std::vector<ResultRow>& rows) {
    CellGroup group;
    for (const ResultRow& row : rows) { group.rows.push_back(&row); }
    return structure_of(group, "structure.symplectic");
}

}  // namespace

TEST_CASE("a defect of steps has the power of h that it follows") {
    const StructureLaw law = structure_law_of(structure_rows(2, 3, 1e-24));
    REQUIRE(law.order);
    CHECK(*law.order == Approx(3));
    CHECK_FALSE(law.kept);
    CHECK(law.steps == 4);
    CHECK(law.largest == Approx(2 * std::pow(64.0, -3)));
    CHECK(structure_text(law) == "h^3.00");
}

TEST_CASE("a property is kept where no defect is seen at three step sizes") {
    CHECK(structure_text(structure_law_of(structure_rows(0, 1, 1e-24))) == "kept");
    CHECK(structure_text(structure_law_of(structure_rows(0, 1, 1e-24, 2))) == "not seen");
    // Seen at the largest step only: it is there, and its order is not known.
    const StructureLaw once = structure_law_of(structure_rows(1, 4, 1e-9));
    CHECK_FALSE(once.kept);
    CHECK_FALSE(once.order);
    CHECK(structure_text(once) == "changed");
    CHECK(structure_text(structure_law_of({})) == "-");
}

TEST_CASE("what is not defined has its reason in the table, and no verdict") {
    Results results;
    results.name = "s";
    results.rows = structure_rows(2, 3, 1e-24);
    nlohmann::json line = result_line("bb", 64, 1e-6, {{"method", "multistep/bliedf2"}});
    line["unmeasured"] = {{"structure.symplectic", "a step depends on earlier ones"}};
    results.rows.push_back(read_result_line(line.dump()));
    const auto tables = tables_named("structure", results);
    REQUIRE(tables.size() == 1);
    const TextTable &full = tables[0].full, &brief = tables[0].brief();
    REQUIRE(full.rows.size() == 2);
    CHECK(full.rows[0][6] == "h^3.00");
    CHECK(full.rows[1].back() == "a step depends on earlier ones");
    REQUIRE(brief.rows.size() == 2);
    CHECK(brief.rows[1][1] == "-");
}
