// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/kinds/curve_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "plots/figures/cells/legends.hpp"
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

// In symbols, of first integrals of a body with its name; empty where an integral has no symbol.
std::string change_of_integral(const std::string& metric) {
    static const std::map<std::string, std::string> of_all = {
        {"invariant.energy", "|E − E_0|"},
        {"invariant.angular_momentum_vertical", "|L_z − L_{z,0}|"},
        {"invariant.angular_momentum_x", "|L_x − L_{x,0}|"},
        {"invariant.angular_momentum_y", "|L_y − L_{y,0}|"},
        {"invariant.angular_momentum_z", "|L_z − L_{z,0}|"},
        {"invariant.momentum_x", "|p_x − p_{x,0}|"},
        {"invariant.momentum_y", "|p_y − p_{y,0}|"},
        {"invariant.momentum_z", "|p_z − p_{z,0}|"}};
    static const std::pair<std::string, std::string> of_bodies[] = {{"invariant.body_momentum_norm", "||m| − |m|_0|"},
                                                                    {"invariant.kovalevskaya", "|K − K_0|"}};
    if (const auto known = of_all.find(metric); known != of_all.end()) { return known->second; }
    for (const auto& [name, symbol] : of_bodies) {
        if (metric == name) { return symbol; }
        if (metric.starts_with(name + "_")) { return symbol + ", " + enhanced_escape(metric.substr(name.size() + 1)); }
    }
    return "";
}

}  // namespace

PanelFigure CurveKind::make_panels(const Results& results) const {
    const std::vector<ResultRow> rows = rows_of(*this, results);
    const std::vector<CellGroup> groups = groups_of(rows);
    const CellNames names(rows);
    const Legends legends(rows, names, facet, names_steps());
    FigureSpec whole = *this;
    whole.select.clear();
    const std::vector<ResultRow> all = rows_of(whole, results);
    Styles styles(all, legends);
    PanelFigure figure{name, enhanced_escape(title), {}, columns};
    for (const std::string& value : facet_values(facet, names, rows)) {
        for (const std::string& metric : metrics) {
            std::optional<Panel> panel = empty_panel(metric, results.units);
            if (!panel) { continue; }
            panel->title = facet_title(facet, value);
            std::vector<CellGroup> drawn;
            for (const CellGroup& group : groups) {
                if (!facet.empty() && names.axis(group.front(), facet) != value) { continue; }
                const auto one = curve(group, metric);
                if (!one) { continue; }
                const std::string called = legends.name(group.front());
                panel->curves.push_back(
                    {label_of(called) + one->remark, one->points, styles.of(group.front()), one->fitted, called});
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
    auto keys = look_keys();
    keys.insert(keys.begin(),
                figure_key("facet", &CurveKind::facet, figure_value::axis(), "one panel for each value of an axis"));
    return keys;
}

std::vector<FigureKey> curve_keys(const std::vector<std::string>& families, const std::vector<std::string>& own) {
    auto keys = layout_keys();
    keys.insert(keys.begin(), figure_key("metric", &CurveKind::metrics, figure_value::metrics(families, own),
                                         "what is drawn, a panel each"));
    return keys;
}

std::string metric_label(const std::string& metric, const Units& units) {
    const std::string change = change_of_integral(metric);
    const MetricDescription* entry = find_metric(metric);
    const std::string symbol = !change.empty()                             ? "max " + change
                               : entry != nullptr && entry->name == metric ? entry->symbol
                               : is_largest_error(metric)                  ? "max " + entry->symbol
                                                                           : enhanced_escape(metric);
    const std::string unit = metric_unit(metric, units);
    return symbol + (unit.empty() || unit == "1" ? "" : " [" + enhanced_escape(unit) + "]");
}

}  // namespace kreisel
