// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/kinds/curve_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "plots/figures/enhanced_text.hpp"
#include "records/metrics/catalogue.hpp"

namespace kreisel {

namespace {

std::vector<std::string> facet_values(const std::string& facet, const CellNames& names,
                                      const std::vector<ResultRow>& rows) {
    if (facet.empty()) { return {""}; }
    std::vector<std::string> values;
    for (const ResultRow& row : rows) {
        const std::string value = names.axis(row, facet);
        if (std::find(values.begin(), values.end(), value) == values.end()) { values.push_back(value); }
    }
    return values;
}

std::string facet_title(const std::string& facet, const std::string& value) {
    return value == "none" && facet == "projection" ? "no projection" : enhanced_escape(value);
}

std::string steps_remark(const ResultRow& row) {
    return row.adaptive() ? fmt::format("tolerance {}", row.tolerance) : fmt::format("h = {:.3g} s", row.h);
}

// Names of groups in a legend, with step sizes if these are named and vary; equal names have equal styles in
// all panels.
class Legends {
  public:
    Legends(const std::vector<ResultRow>& rows, const CellNames& names, const std::string& facet, bool names_steps)
        : names_(names), axes_(names.varying_axes(facet.empty() ? std::vector<std::string>{} : std::vector{facet})) {
        const auto other = [&](const ResultRow& row) {
            return row.steps != rows.front().steps || row.tolerance != rows.front().tolerance;
        };
        with_steps_ = names_steps && std::any_of(rows.begin(), rows.end(), other);
    }

    std::string name(const ResultRow& row) const {
        std::string text = axes_.empty() && with_steps_ ? "" : names_.legend(row, axes_);
        if (with_steps_) { text += (text.empty() ? "" : ", ") + steps_remark(row); }
        return text;
    }
    int style(const std::string& name) {
        return styles_.insert({name, static_cast<int>(styles_.size()) + 1}).first->second;
    }

  private:
    const CellNames& names_;
    std::vector<std::string> axes_;
    bool with_steps_ = false;
    std::map<std::string, int> styles_;
};

}  // namespace

PanelFigure CurveKind::panels(const Results& results, const std::filesystem::path& folder) const {
    const std::vector<ResultRow> rows = rows_of(results);
    const std::vector<CellGroup> groups = groups_of(rows);
    const CellNames names(rows);
    Legends legends(rows, names, facet, names_steps());
    PanelFigure figure{name, enhanced_escape(title), {}, columns};
    for (const std::string& value : facet_values(facet, names, rows)) {
        for (const std::string& metric : metrics) {
            std::optional<Panel> panel = empty_panel(metric, results.units);
            if (!panel) { continue; }
            panel->title = facet_title(facet, value);
            std::vector<CellGroup> drawn;
            for (const CellGroup& group : groups) {
                if (!facet.empty() && names.axis(group.front(), facet) != value) { continue; }
                const auto one = curve(group, metric, folder);
                if (!one) { continue; }
                const std::string label = legends.name(group.front());
                panel->curves.push_back(
                    {enhanced_escape(label) + one->remark, one->points, legends.style(label), one->fitted});
                if (!one->guide.empty()) { panel->guides.push_back(one->guide); }
                drawn.push_back(group);
            }
            complete(*panel, drawn, metric);
            if (!drawn.empty()) { figure.panels.push_back(std::move(*panel)); }
        }
    }
    if (figure.panels.empty()) { throw FigureError(fmt::format("{}: the selected cells hold no {}", name, lacking())); }
    return figure;
}

std::vector<FigureKey> layout_keys() {
    return {figure_key("facet", &CurveKind::facet, figure_value::axis(), "one panel for each value of an axis"),
            figure_key("columns", &CurveKind::columns, figure_value::count(1, 4, "panels beside each other"),
                       "panels beside each other")};
}

std::vector<FigureKey> curve_keys(const std::vector<std::string>& families, const std::vector<std::string>& own) {
    auto keys = layout_keys();
    keys.insert(keys.begin(), figure_key("metric", &CurveKind::metrics, figure_value::metrics(families, own),
                                         "what is drawn, a panel each"));
    return keys;
}

std::string metric_label(const std::string& metric, const Units& units) {
    static const std::map<std::string, std::string> integrals = {
        {"invariant.energy", "max |E − E_0|"}, {"invariant.angular_momentum_vertical", "max |L_z − L_{z,0}|"}};
    const auto integral = integrals.find(metric);
    const MetricDescription* entry = find_metric(metric);
    const std::string symbol = integral != integrals.end()                 ? integral->second
                               : entry != nullptr && entry->name == metric ? entry->symbol
                               : is_largest_error(metric)                  ? "max " + entry->symbol
                                                                           : enhanced_escape(metric);
    const std::string unit = metric_unit(metric, units);
    return symbol + (unit.empty() || unit == "1" ? "" : " [" + enhanced_escape(unit) + "]");
}

}  // namespace kreisel
