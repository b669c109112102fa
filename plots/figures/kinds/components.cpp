// SPDX-License-Identifier: BSD-3-Clause
//
// The components of x, v, omega or the multipliers of one trajectory against time or cost.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "plots/figures/cells/select.hpp"
#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/kind.hpp"
#include "plots/figures/kinds/abscissa_value.hpp"
#include "plots/figures/kinds/panel_kind.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

namespace {

const std::map<std::string, std::string> component_symbols = {
    {"x", "x"}, {"v", "v"}, {"omega", "ω"}, {"multipliers", "λ"}};

struct Component {
    std::string name, label, unit;  // "x1", or "pin.1" of multipliers
    const std::vector<double>* values;
};

// Of a vector of a body, or of all multipliers: forces, then torques.
std::vector<Component> components_of(const std::string& prefix, const std::string& symbol,
                                     const TrajectoryTable& trajectory) {
    std::vector<Component> all;
    for (std::size_t i = 0; i < trajectory.names.size(); ++i) {
        const std::string& name = trajectory.names[i];
        if (!name.starts_with(prefix)) { continue; }
        const std::string index = enhanced_escape(name.substr(prefix.size()));
        const std::string label =
            index.size() > 1 ? fmt::format("{}_{{{}}}", symbol, index) : fmt::format("{}_{}", symbol, index);
        all.push_back({name.substr(name.find('.') + 1), label, trajectory.units[i], &trajectory.columns[i]});
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.unit < b.unit; });
    return all;
}

class ComponentsFigure final : public PanelKind {
  public:
    std::string body;
    std::optional<double> until;
    std::string quantity = "x";
    bool stacked = false;
    std::string x = "t";  ///< or a cost

    std::string drawn_against() const override { return x == "t" ? "" : x; }
    std::string drawn_body() const override { return body; }
    std::optional<double> drawn_until() const override { return until; }

  private:
    PanelFigure make_panels(const Results& results) const override {
        const ResultRow row = selected_trajectory(*this, results);
        const TrajectoryTable trajectory = samples_until(until, row);
        auto at = abscissa_of_samples(read_trajectory(row), row, x);
        auto components = components_of(prefix_in(trajectory), symbol(), trajectory);
        if (!at) { throw FigureError(fmt::format("{}: the trajectory does not tell {}", name, x)); }
        at->resize(trajectory.columns.front().size());
        if (components.empty()) {
            throw FigureError(fmt::format("{}: the trajectory has no columns {}{}, ...", name, prefix_in(trajectory),
                                          draws_multipliers() ? "JOINT.1" : "1"));
        }
        PanelFigure figure{name, enhanced_escape(title), {}, columns};
        if (stacked) { figure.axes_height = 2.2; }
        std::string unit;
        for (Component& component : components) {
            if (legend.contains(component.name)) { component.label = label_of(component.name); }
            if (stacked || figure.panels.empty() || component.unit != unit) {
                unit = component.unit;
                add_panel(component, figure);
            }
            auto& curves = figure.panels.back().curves;
            curves.push_back({stacked ? "" : component.label,
                              zipped(*at, *component.values),
                              stacked ? 1 : static_cast<int>(curves.size()) + 1,
                              {},
                              component.name});
        }
        return figure;
    }
    bool draws_multipliers() const { return quantity == "multipliers"; }
    const std::string& symbol() const { return component_symbols.at(quantity); }
    // What the names of the columns begin with.
    std::string prefix_in(const TrajectoryTable& trajectory) const {
        return draws_multipliers() ? "lambda." : body_of(*this, body, trajectory) + "." + quantity;
    }
    void add_panel(const Component& first, PanelFigure& figure) const {
        if (!figure.panels.empty() && columns == 1) { figure.panels.back().x_label.clear(); }
        const std::string label = fmt::format("{} [{}]", stacked ? first.label : symbol(), first.unit);
        figure.panels.push_back({"", abscissa_label(x), label, false, false, {}, {}, {}});
    }
};

}  // namespace

KREISEL_FIGURE(
    ComponentsFigure,
    {.name = "components",
     .summary = "the components of x, v, omega or the multipliers of one trajectory against time or cost",
     .draws = FigureData::samples,
     .script = "lines",
     .keys = {figure_key("body", &ComponentsFigure::body, figure_value::text("the name of a body"), "which body",
                         "the first"),
              figure_key("until", &ComponentsFigure::until, figure_value::positive("a time greater than 0, s"),
                         "up to which time", "all"),
              figure_key("quantity", &ComponentsFigure::quantity,
                         figure_value::choice("quantity", {"x", "v", "omega", "multipliers"}), "what is drawn"),
              figure_key("x", &ComponentsFigure::x, abscissa_value(times_and_costs()),
                         "what they are drawn against: time or, in an experiment of kind work_precision, cost"),
              figure_key("stacked", &ComponentsFigure::stacked, figure_value::flag(), "a panel for each component"),
              figure_key("columns", &ComponentsFigure::columns, figure_value::count(1, 4, "panels beside each other"),
                         "panels beside each other")}});

}  // namespace kreisel
