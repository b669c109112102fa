// SPDX-License-Identifier: BSD-3-Clause
//
// Which rows are independent, for few rows and for so many that sparse factors are used.
#include "mechanics/solve/rank.hpp"

#include <algorithm>

#include "tests/mechanics/models/models.hpp"

using namespace kreisel;
using namespace models;

namespace {

/// Columns that each touch the next row too, the first `repeated` of them once more at the end, three times as long.
MatX chained(Eigen::Index columns, Eigen::Index repeated) {
    MatX A = MatX::Zero(columns + 1, columns);
    for (Eigen::Index k = 0; k < columns - repeated; ++k) A(k, k) = 1, A(k + 1, k) = Real(2 + k % 3);
    A.rightCols(repeated) = 3 * A.leftCols(repeated);
    return A;
}

}  // namespace

TEST_CASE("of columns that repeat others one of each pair is chosen", "[rank]") {
    for (const int columns : {60, 401, 600}) {
        INFO(columns);
        constexpr int repeated = 7;
        const RowChoice choice = choose_rows(chained(columns, repeated), columns);
        CHECK(choice.rank == columns - repeated);
        for (std::size_t k = 0; k < choice.independent.size(); ++k) {
            const std::size_t other = k + static_cast<std::size_t>(columns - repeated);
            const bool has_pair = k < repeated, is_repetition = k >= static_cast<std::size_t>(columns - repeated);
            if (has_pair) CHECK(choice.independent[k] != choice.independent[other]);
            if (!has_pair && !is_repetition) CHECK(choice.independent[k]);
        }
    }
}

TEST_CASE("no more columns are chosen than are asked for", "[rank]") {
    for (const int columns : {60, 600}) {
        const RowChoice choice = choose_rows(chained(columns, 0), 50);
        CHECK(choice.rank == 50);
        CHECK(std::count(choice.independent.begin(), choice.independent.end(), true) == 50);
    }
    CHECK(choose_rows(MatX(6, 0), 6).rank == 0);
}
