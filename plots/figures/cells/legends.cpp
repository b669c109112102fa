// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/cells/legends.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace kreisel {

namespace {

std::string steps_remark(const ResultRow& row) {
    return row.adaptive() ? fmt::format("tolerance {}", row.tolerance) : fmt::format("h = {:.3g} s", row.h);
}

std::vector<std::string> left_out(const std::string& facet) {
    return facet.empty() ? std::vector<std::string>{} : std::vector{facet};
}

}  // namespace

Legends::Legends(const std::vector<ResultRow>& rows, const CellNames& names, const std::string& facet, bool names_steps)
    : names_(names), axes_(names.varying_axes(left_out(facet))) {
    const auto other = [&](const ResultRow& row) {
        return row.steps != rows.front().steps || row.tolerance != rows.front().tolerance;
    };
    with_steps_ = names_steps && std::any_of(rows.begin(), rows.end(), other);
}

std::string Legends::name(const ResultRow& row) const {
    std::string text = axes_.empty() && with_steps_ ? "" : names_.legend(row, axes_);
    if (with_steps_) { text += (text.empty() ? "" : ", ") + steps_remark(row); }
    return text;
}

Styles::Styles(const std::vector<ResultRow>& all, const Legends& legends)
    : names_(all), axes_(legends.axes()), with_steps_(legends.with_steps()) {
    by_method_ = std::erase(axes_, "method") > 0;
    for (const ResultRow& row : all) { hues_.of(hue(row)), variants_.of(variant(row)); }
}

int Styles::of(const ResultRow& row) {
    constexpr int colours = 7;  // plots/gnuplot/style.gp
    const int rank = hues_.of(hue(row)), variant_rank = variants_.of(variant(row));
    return 1 + rank % colours + colours * (rank / colours * variants_.size() + variant_rank);
}

std::string Styles::rest(const ResultRow& row) const {
    return (axes_.empty() ? "" : names_.legend(row, axes_)) + (with_steps_ ? steps_remark(row) : "");
}

}  // namespace kreisel
