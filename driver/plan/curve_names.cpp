// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/curve_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

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

class KnownNames {
  public:
    KnownNames(const PanelKind& figure, const std::vector<ResultRow>& cells) {
        const CellNames names(cells);
        const auto axes = names.varying_axes({});
        for (const Overlay& overlay : figure.overlays) { whole_.insert(overlay.label); }
        for (const ResultRow& cell : cells) {
            whole_.insert(names.legend(cell, axes));
            for (const std::string& axis : CellNames::figure_axes()) { parts_.insert(names.axis(cell, axis)); }
            labels_.insert(cell.label);
            optioned_.insert({cell.method, cell.projection});
        }
        parts_.insert("no projection");
        optioned_.erase("none");
    }

    bool may_be(const std::string& name) const {
        if (whole_.contains(name)) { return true; }
        std::string rest = name;
        for (const std::string& label : labels_) {  // which may hold commas
            if (rest.starts_with(label + ", ")) { rest = rest.substr(label.size() + 2); }
        }
        while (true) {
            const auto comma = rest.find(", ");
            if (!may_be_part(rest.substr(0, comma))) { return false; }
            if (comma == std::string::npos) { return true; }
            rest = rest.substr(comma + 2);
        }
    }
    std::vector<std::string> all() const { return {whole_.begin(), whole_.end()}; }

  private:
    bool may_be_part(const std::string& part) const {
        const bool is_size = part.starts_with("h = ") || part.starts_with("tolerance ");
        return is_size || parts_.contains(part) || optioned_.contains(part.substr(0, part.find(' ')));
    }

    std::set<std::string> whole_, parts_, labels_;
    std::set<std::string> optioned_;  // methods and projections, whose options follow
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
