// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/figures/curve_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "plots/figures/cells/legends.hpp"
#include "plots/figures/kinds/curve_kind.hpp"
#include "plots/figures/kinds/phase_kind.hpp"
#include "records/json/node.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

// Figures whose curves are called by their cells; null for others.
const PanelKind* called_by_cells(const Figure& figure) {
    const bool by_cells =
        dynamic_cast<const CurveKind*>(&figure) != nullptr || dynamic_cast<const PhaseKind*>(&figure) != nullptr;
    return by_cells ? dynamic_cast<const PanelKind*>(&figure) : nullptr;
}

// Takes a part from the beginning of what is left of a name, if it stands there with another behind it or nothing.
bool take(std::string_view& rest, std::string_view text) {
    constexpr std::string_view separator = ", ";
    if (text.empty() || !rest.starts_with(text)) { return false; }
    const std::string_view behind = rest.substr(text.size());
    const bool goes_on = behind.size() > separator.size() && behind.starts_with(separator);
    if (!behind.empty() && !goes_on) { return false; }
    rest = behind.empty() ? behind : behind.substr(separator.size());
    return true;
}

using Options = std::map<std::string, std::string>;

// One part of a name: a method or a projection with any of its options.
bool take_optioned(std::string_view& rest, const std::string& name, const Options& options) {
    std::vector<std::string> words = option_texts(options);
    words.emplace_back("adaptive");
    std::string part = name;
    for (const std::string& word : words) {
        if (rest.starts_with(part + " " + word)) { part += " " + word; }
    }
    return take(rest, part);
}

// Takes the value of a cell on an axis.
void take_value(std::string_view& rest, const ResultRow& cell, const std::string& axis) {
    if (axis == "results") { take(rest, cell.results); }
    if (axis == "problem") { take(rest, cell.label); }
    if (axis == "formulation") { take(rest, cell.formulation); }
    if (axis == "method") { take_optioned(rest, cell.method, cell.options); }
    if (axis == "projection" && cell.projection == "none") { take(rest, "no projection"); }
    if (axis == "projection" && cell.projection != "none") {
        take_optioned(rest, cell.projection, cell.projection_options);
    }
    if (axis == "precision") { take(rest, cell.precision); }
}

// Whether a name consists of values of a cell, in the order of legends, each once. What a panel is for stands above it.
bool may_name(std::string_view name, const ResultRow& cell, const std::string& facet) {
    std::string_view rest = name;
    for (const std::string& axis : CellNames::figure_axes()) {
        if (axis != facet) { take_value(rest, cell, axis); }
    }
    const bool is_size = rest.starts_with("h = ") || rest.starts_with("tolerance ");
    return !name.empty() && (rest.empty() || is_size);
}

class KnownNames {
  public:
    KnownNames(const PanelKind& figure, const std::vector<ResultRow>& cells) : cells_(cells) {
        const auto* curves = dynamic_cast<const CurveKind*>(&figure);
        if (curves != nullptr) { facet_ = curves->facet; }
        const CellNames names(cells);
        const auto axes = names.varying_axes({facet_});
        for (const Overlay& overlay : figure.overlays) { whole_.insert(overlay.label); }
        for (const ResultRow& cell : cells) { whole_.insert(names.legend(cell, axes)); }
    }
    bool may_be(const std::string& name) const {
        return whole_.contains(name) || std::any_of(cells_.begin(), cells_.end(), [&](const ResultRow& cell) {
                   return may_name(name, cell, facet_);
               });
    }
    std::vector<std::string> all() const { return {whole_.begin(), whole_.end()}; }

  private:
    const std::vector<ResultRow>& cells_;
    std::string facet_;  // an axis, or none
    std::set<std::string> whole_;
};

void check_name(const std::string& name, const std::string& pointer, const KnownNames& known, Diagnostics& sink) {
    if (known.may_be(name)) { return; }
    sink.add({.pointer = pointer,
              .expected = "a name that a curve of this experiment can have in a legend",
              .got = in_quotes(name),
              .suggestion = nearest_name(name, known.all()),
              .rule = Rule::figure_curve});
}

std::string escaped(std::string key) {
    for (const auto& [what, by] : {std::pair("~", "~0"), std::pair("/", "~1")}) {
        for (auto at = key.find(what); at != std::string::npos; at = key.find(what, at + 2)) { key.replace(at, 1, by); }
    }
    return key;
}

}  // namespace

bool names_curves(const Figure& figure) {
    const PanelKind* kind = called_by_cells(figure);
    return kind != nullptr && (!kind->legend.empty() || !kind->order.empty());
}

void check_curve_names(const Figure& figure, const std::vector<ResultRow>& cells, Diagnostics& sink) {
    const PanelKind* kind = called_by_cells(figure);
    if (kind == nullptr || cells.empty()) { return; }
    const KnownNames known(*kind, cells);
    for (const auto& [name, label] : kind->legend) {
        check_name(name, figure.pointer + "/legend/" + escaped(name), known, sink);
    }
    for (std::size_t i = 0; i < kind->order.size(); ++i) {
        check_name(kind->order[i], fmt::format("{}/order/{}", figure.pointer, i), known, sink);
    }
}

}  // namespace kreisel
