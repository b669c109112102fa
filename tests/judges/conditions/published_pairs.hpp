// SPDX-License-Identifier: BSD-3-Clause
//
// Embedded pairs whose sources print fewer digits than quad has, as printed, and what of them is known exactly.
#pragma once

#include <string>
#include <vector>

#include "methods/conditions/numeric_tableau.hpp"

namespace kreisel::orders {

/// A coefficient, by the indices of the literature, from 1.
struct Entry {
    enum class Of { c, a, b, b_hat } of;
    std::size_t i, j = 0;
    bool operator==(const Entry&) const = default;
};

struct ExactEntry {
    Entry entry;
    Float100 value;
};

struct PublishedPair {
    std::string method;  ///< as registered
    int order, embedded;
    std::vector<std::vector<std::string>> a;
    std::vector<std::string> b, e;  ///< e = b - b^
    bool last_row_is_b;             ///< a row more than `a` has
    std::vector<ExactEntry> exact;  ///< to be held as long as they are independent, the first ones first
    Float100 printed_to;            ///< no printed number is further from the exact one
};

/// [tsitouras2011], 16 digits.
PublishedPair published_tsit5();
/// The code of [hairer1993], 30 digits; of its two estimates, that by the solution of order 5.
PublishedPair published_dop853();

}  // namespace kreisel::orders
