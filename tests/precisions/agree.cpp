// SPDX-License-Identifier: BSD-3-Clause
//
// Quad against double: the same source at the same points differs by round-off of double, and not by less.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/precisions/values/values.hpp"

namespace {

/// |wide - narrow| in units of the spacing of double at max(1, |wide|).
double difference(const Value& narrow, const Value& wide) {
    const double size = std::max(1.0, std::abs(wide.high));
    return std::abs((wide.high - narrow.high) + wide.low) / (size * 2.220446049250313e-16);
}

}  // namespace

TEST_CASE("the maps of the groups agree in double and quad to round-off of double", "[precisions]") {
    const auto narrow = values_binary64(), wide = values_binary128();
    REQUIRE(narrow.size() == wide.size());
    double worst = 0;
    for (std::size_t i = 0; i < wide.size(); ++i) {
        INFO(wide[i].name << ": " << narrow[i].high << " and " << wide[i].high);
        REQUIRE(narrow[i].name == wide[i].name);
        const double ulps = difference(narrow[i], wide[i]);
        CHECK(ulps <= 64);
        worst = std::max(worst, ulps);
    }
    INFO("worst " << worst << " of " << wide.size());
    CHECK(worst > 0);  // equal to the last bit would mean that quad is double
}

TEST_CASE("quad carries digits below double", "[precisions][control]") {
    const auto wide = values_binary128();
    CHECK(std::count_if(wide.begin(), wide.end(), [](const Value& v) { return v.low != 0; }) >
          static_cast<long>(wide.size()) / 4);
    Value off = wide.front();
    off.high += 1e-13;
    CHECK(difference(off, wide.front()) > 64);
}
