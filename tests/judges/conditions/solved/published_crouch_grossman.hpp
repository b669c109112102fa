// SPDX-License-Identifier: BSD-3-Clause
//
// Crouch-Grossman methods whose source prints 16 decimals [jackiewicz2000], as printed, or closed forms
// [owrenmarthinsen1999], as 60 decimals; and where the search for an embedded solution of the order below, with one
// stage more, has ended.
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
PublishedCrouchGrossman published_cg43();  ///< closed forms

}  // namespace kreisel::orders
