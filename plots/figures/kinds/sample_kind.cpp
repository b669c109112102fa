// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/kinds/sample_kind.hpp"

#include <fmt/format.h>

#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/select.hpp"

namespace kreisel {

std::vector<ResultRow> SampleKind::rows_of(const Results& results) const {
    return with_samples(selected_rows(*this, results, true), *this);
}

std::vector<CellGroup> SampleKind::groups_of(const std::vector<ResultRow>& rows) const {
    std::vector<CellGroup> groups;
    for (const ResultRow& row : rows) { groups.push_back({{&row}}); }
    return groups;
}

std::string end_text(const ResultRow& row) {
    return enhanced_escape(row.status) + fmt::format(" at {:.3g} s", row.t_reached);
}

}  // namespace kreisel
