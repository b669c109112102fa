// SPDX-License-Identifier: BSD-3-Clause
//
// Every model, method, formulation and projection, described in other units, places, directions, axes and orders.
#include <catch2/catch.hpp>
#include <iostream>

#include "methods/contract/method.hpp"
#include "tests/metamorphic/suite.hpp"

using namespace kreisel;
using namespace kreisel::metamorphic;

namespace {

constexpr int steps = KREISEL_QUAD ? 8 : 64;

/// The required numbers of comparisons, by class.
struct Least {
    int bits, round_off, truncation;
};

void check(Extent extent, const Least& least) {
    Report report = compare_all(select(extent), steps);
    std::cout << to_text(report);
    CHECK(report.compared[to_text(Agreement::bits)] >= least.bits);
    CHECK(report.compared[to_text(Agreement::round_off)] >= least.round_off);
    CHECK(report.compared[to_text(Agreement::truncation)] >= least.truncation);
    CHECK(report.objections.empty());
    if (extent == Extent::sparse) return;  // too few comparisons for each exception to be needed
    for (const auto& [reason, count] : report.covered) {
        INFO("no longer needed: " << reason);
        CHECK(report.excepted.contains(reason));
    }
}

}  // namespace

TEST_CASE("methods exempt from rotation declare it themselves", "[metamorphic]") {
    for (const Exception& exception : exceptions())
        if (exception.transformation == "turned") CHECK_FALSE(method(exception.method).description.equivariant);
}

TEST_CASE("descriptions of one motion agree", "[metamorphic]") {
    if (KREISEL_QUAD)
        check(Extent::sparse, {400, 200, 100});
    else
        check(Extent::pairwise, {5000, 2500, 900});
}

// Takes some twenty minutes in double and hours in quad: `ctest --preset ci -C full -L full`.
TEST_CASE("descriptions of one motion agree, in every combination", "[.][full]") {
    check(Extent::full, {10000, 10000, 5000});
}
