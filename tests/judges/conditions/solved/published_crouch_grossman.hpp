// SPDX-License-Identifier: BSD-3-Clause
//
// Crouch-Grossman methods whose source prints 16 decimals [jackiewicz2000], as printed, and where the search for an
// embedded solution of the order below, with one stage more, has ended.
#pragma once

#include <string>
#include <vector>

namespace kreisel::orders {

using PrintedRow = std::vector<std::string>;

struct PublishedCrouchGrossman {
    std::string method;  ///< as registered
    int order;
    std::vector<PrintedRow> a;
    PrintedRow b;
    PrintedRow last_row, b_hat;  ///< a start for the embedded solution, not published
};

PublishedCrouchGrossman published_cg4a();
PublishedCrouchGrossman published_cg5a();

}  // namespace kreisel::orders
