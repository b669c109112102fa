// SPDX-License-Identifier: BSD-3-Clause
//
// What trials tell of properties, from results with known answers.
#include "driver/cli/certify/findings.hpp"

#include <catch2/catch.hpp>

#include "driver/cli/certify/sheet.hpp"

using namespace kreisel;

namespace {

// Cells of one problem whose steps keep the two-form, and whose reversal is off by h^2.
void add_cells(Results& results, const std::string& problem, const std::string& formulation, double energy) {
    for (const long steps : {16L, 32L, 64L}) {
        ResultRow row;
        row.problem = row.label = problem;
        row.formulation = formulation;
        row.method = "some/method";
        row.precision = "quad";
        row.status = "ok";
        row.steps = steps;
        row.h = 1.0 / static_cast<double>(steps);
        row.metrics = {{"structure.symplectic.uncertainty", 1e-24}, {"structure.reversal.uncertainty", 1e-30},
                       {"structure.reversal", row.h * row.h},       {"invariant.energy", 5},
                       {"invariant.energy.relative", energy},       {"invariant.energy.slope", 1}};
        results.rows.push_back(row);
    }
}

Results structure_results(double energy_of_free, double energy_in_potential) {
    Results results;
    add_cells(results, "free_top", "SO3", energy_of_free);
    add_cells(results, "heavy_top", "SO3", energy_in_potential);
    add_cells(results, "heavy_top", "SO3xR3", 1);
    return results;
}

}  // namespace

TEST_CASE("what is seen and not declared is a remark, on the largest class that has it") {
    const MethodDescription silent{.name = "some/method"};
    const Findings found = structure_findings(silent, structure_results(1e-33, 1e-3));
    CHECK(found.complaints.empty());
    REQUIRE(found.remarks.size() == 2);
    CHECK_THAT(found.remarks[0], Catch::StartsWith("symplectic on constrained systems"));
    CHECK_THAT(found.remarks[1], Catch::StartsWith("energy-preserving on free systems"));
    // Not on the free body: then not on the larger class either.
    CHECK(structure_findings(silent, structure_results(1e-3, 1e-33)).remarks.size() == 1);
}

TEST_CASE("what is declared and not seen is a complaint, and what is seen is not a remark") {
    MethodDescription bold{.name = "some/method"};
    bold.preserves = {{Property::symplectic, Domain::constrained},
                      {Property::symmetric, Domain::free},
                      {Property::energy, Domain::potential}};
    const Findings found = structure_findings(bold, structure_results(1e-33, 1e-3));
    CHECK(found.remarks.empty());
    CHECK(found.complaints == std::vector<std::string>{"it declares to be symmetric on free systems, and is not",
                                                       "it declares to be energy-preserving on potential systems, "
                                                       "and is not"});
}

TEST_CASE("what is declared of a class without cells is a complaint") {
    Results free_alone;
    add_cells(free_alone, "free_top", "SO3", 1e-33);
    MethodDescription bold{.name = "some/method"};
    bold.preserves = {{Property::symplectic, Domain::potential}, {Property::energy, Domain::free}};
    const std::vector<std::string> expected = {
        "it declares to be symplectic on potential systems, and no cell shows it"};
    CHECK(structure_findings(bold, free_alone).complaints == expected);
    CHECK(structure_findings(bold, {}).complaints.size() == 2);
    // Of autonomous systems jointed ones are the most that trials have.
    bold.preserves = {{Property::symplectic, Domain::autonomous}};
    CHECK(structure_findings(bold, structure_results(1e-33, 1e-3)).complaints.empty());
    CHECK(structure_findings(bold, free_alone).complaints.size() == 1);
}

TEST_CASE("remarks stand below the tables of a sheet in every format") {
    DataSheet sheet{.title = "some/method", .paragraphs = {}, .tables = {}};
    CHECK(terminal_text(sheet).find("Remarks") == std::string::npos);
    sheet.remarks = {"50 % of_it"};
    CHECK_THAT(terminal_text(sheet), Catch::EndsWith("\nRemarks\n  50 % of_it\n"));
    CHECK_THAT(markdown_text(sheet), Catch::EndsWith("\n## Remarks\n\n- 50 % of_it\n"));
    CHECK_THAT(latex_text(sheet), Catch::Contains("\\item 50 \\% of\\_it\n\\end{itemize}"));
}
