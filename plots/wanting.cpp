// SPDX-License-Identifier: BSD-3-Clause
#include "plots/wanting.hpp"

#include <fmt/format.h>

#include <iostream>

#include "records/cell/stepping.hpp"

namespace kreisel {

void print_wanting(const Results& results) {
    if (!results.warning.empty()) { std::cerr << results.warning << "\n"; }
    for (const std::string& damage : results.damage) { std::cerr << damage << "\n"; }
    for (const auto* rows : {&results.rows, &results.missing}) {
        for (const ResultRow& row : *rows) {
            if (row.ok() || row.status == "skipped") { continue; }
            std::cerr << fmt::format("{}: {} on {} {}, projection {}, {}, {}\n", row.status, row.method, row.label,
                                     row.formulation, row.projection, row.precision, stepping_text(row));
        }
    }
}

}  // namespace kreisel
