// SPDX-License-Identifier: BSD-3-Clause
//
// The components of x, v or omega of a body, or of what joints and forces exert, of one trajectory against time or
// cost.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "plots/figures/cells/select.hpp"
#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/kind.hpp"
#include "plots/figures/kinds/abscissa_value.hpp"
#include "plots/figures/kinds/panel_kind.hpp"
#include "records/reading/trajectory_table.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

const std::map<std::string, std::string> body_symbols = {{"x", "x"}, {"v", "v"}, {"omega", "ω"}};
// What the columns of a quantity of joints or forces begin with.
const std::map<std::string, std::string> joint_columns = {
    {"multipliers", "lambda."}, {"reactions", "reaction."}, {"drives", "drive."}, {"exerted", "exerted."}};

struct Component {
    std::string name, symbol, index, unit;  // "x1", "x", "1", or "pin.force.1", "F", "pin.1" of a joint
    const std::vector<double>* values;

    std::string label() const {
        const std::string text = enhanced_escape(index);
        return index.size() > 1 ? fmt::format("{}_{{{}}}", symbol, text) : fmt::format("{}_{}", symbol, text);
    }
};

Component component_of_joint(const std::string& name, const std::string& unit, const std::vector<double>* values) {
    for (const auto& [word, symbol] : {std::pair<std::string, std::string>{".force", "F"}, {".torque", "τ"}}) {
        const std::size_t at = name.rfind(word);
        if (at != std::string::npos) {
            return {name, symbol, name.substr(0, at) + name.substr(at + word.size()), unit, values};
        }
    }
    return {name, "λ", name, unit, values};
}

bool is_zero(const Component& component) {
    return std::all_of(component.values->begin(), component.values->end(), [](double value) { return value == 0; });
}

// Names of joints and forces, "pin" of "pin.force.1".
std::vector<std::string> joints_of(const std::vector<Component>& components) {
    std::vector<std::string> names;
    for (const Component& component : components) {
        const std::string& index = component.index;
        const std::size_t dot = index.rfind('.');
        const bool numbered =
            dot != std::string::npos && index.find_first_not_of("0123456789", dot + 1) == std::string::npos;
        const std::string joint = numbered ? index.substr(0, dot) : index;
        if (std::find(names.begin(), names.end(), joint) == names.end()) { names.push_back(joint); }
    }
    return names;
}

class ComponentsFigure final : public PanelKind {
  public:
    std::string body;
    std::string joint;  ///< or force, of quantities of these; empty: all
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
        const auto components = components_in(trajectory);
        if (!at) { throw FigureError(fmt::format("{}: the trajectory does not tell {}", name, x)); }
        at->resize(trajectory.columns.front().size());
        PanelFigure figure{name, enhanced_escape(title), {}, columns};
        if (stacked) { figure.axes_height = 2.2; }
        std::string unit;
        for (const Component& component : components) {
            if (stacked || figure.panels.empty() || component.unit != unit) {
                unit = component.unit;
                add_panel(component, figure);
            }
            auto& curves = figure.panels.back().curves;
            curves.push_back({stacked ? "" : label_in_legend(component),
                              zipped(*at, *component.values),
                              stacked ? 1 : static_cast<int>(curves.size()) + 1,
                              {},
                              component.name});
        }
        return figure;
    }
    bool is_of_joints() const { return joint_columns.contains(quantity); }
    std::string label_in_legend(const Component& component) const {
        return legend.contains(component.name) ? label_of(component.name) : component.label();
    }
    // Of a vector of a body, or of all joints: forces, then torques.
    std::vector<Component> components_in(const TrajectoryTable& trajectory) const {
        const std::string prefix =
            is_of_joints() ? joint_columns.at(quantity) : body_of(*this, body, trajectory) + "." + quantity;
        std::vector<Component> all;
        for (std::size_t i = 0; i < trajectory.names.size(); ++i) {
            const std::string& column = trajectory.names[i];
            if (!column.starts_with(prefix)) { continue; }
            const std::string rest = column.substr(prefix.size());
            const auto* values = &trajectory.columns[i];
            all.push_back(is_of_joints() ? component_of_joint(rest, trajectory.units[i], values)
                                         : Component{quantity + rest, body_symbols.at(quantity), rest,
                                                     trajectory.units[i], values});
        }
        if (all.empty()) {
            throw FigureError(fmt::format("{}: the trajectory has no columns {}{}, ...", name, prefix,
                                          is_of_joints() ? "JOINT.1" : "1"));
        }
        keep_joint(all);
        if (is_of_joints()) { leave_out_zeros(all); }
        std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.unit < b.unit; });
        return all;
    }
    void keep_joint(std::vector<Component>& components) const {
        if (joint.empty()) { return; }
        if (!is_of_joints()) {
            throw FigureError(fmt::format("{}: {} is of a \"body\", not a \"joint\"", name, quantity));
        }
        const auto names = joints_of(components);
        if (std::find(names.begin(), names.end(), joint) == names.end()) {
            const std::string nearest = nearest_name(joint, names);
            throw FigureError(fmt::format("{}: the trajectory has no {} of \"{}\", but of {}{}", name, quantity, joint,
                                          fmt::join(names, ", "),
                                          nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?"));
        }
        std::erase_if(components, [&](const Component& one) { return joints_of({one}).front() != joint; });
    }
    // What a joint never exerts, as the torque of a spherical one, unless there is nothing else or the figure names it.
    void leave_out_zeros(std::vector<Component>& components) const {
        const auto vector_of = [](const Component& one) { return one.symbol + joints_of({one}).front(); };
        std::set<std::string> exerted;
        for (const Component& one : components) {
            const bool named =
                legend.contains(one.name) || std::find(order.begin(), order.end(), one.name) != order.end();
            if (named || !is_zero(one)) { exerted.insert(vector_of(one)); }
        }
        if (exerted.empty()) { return; }
        std::erase_if(components, [&](const Component& one) { return !exerted.contains(vector_of(one)); });
    }
    void add_panel(const Component& first, PanelFigure& figure) const {
        if (!figure.panels.empty() && columns == 1) { figure.panels.back().x_label.clear(); }
        const std::string label = fmt::format("{} [{}]", stacked ? label_in_legend(first) : first.symbol, first.unit);
        figure.panels.push_back({"", abscissa_label(x), label, false, false, {}, {}, {}});
    }
};

std::vector<FigureKey> components_keys() {
    auto keys = look_keys();
    keys.insert(
        keys.begin(),
        {figure_key("body", &ComponentsFigure::body, figure_value::text("the name of a body"), "which body",
                    "the first"),
         figure_key("joint", &ComponentsFigure::joint, figure_value::text("the name of a joint or a force"),
                    "which joint, of multipliers, reactions and drives, or which force of those exerted", "all"),
         figure_key("until", &ComponentsFigure::until, figure_value::positive("a time greater than 0, s"),
                    "up to which time", "all"),
         figure_key(
             "quantity", &ComponentsFigure::quantity,
             figure_value::choice("quantity", {"x", "v", "omega", "multipliers", "reactions", "drives", "exerted"}),
             "what is drawn: a vector of the body, or of joints the multipliers, the reactions or what drives "
             "them, or what springs, dampers, bushings and attractions exert"),
         figure_key("x", &ComponentsFigure::x, abscissa_value(times_and_costs()),
                    "what they are drawn against: time or, in an experiment of kind work_precision, cost"),
         figure_key("stacked", &ComponentsFigure::stacked, figure_value::flag(), "a panel for each component")});
    return keys;
}

}  // namespace

KREISEL_FIGURE(ComponentsFigure,
               {.name = "components",
                .summary = "the components of x, v or omega of a body, or of what joints and forces exert, of one "
                           "trajectory against time or cost",
                .draws = FigureData::samples,
                .script = "lines",
                .keys = components_keys()});

}  // namespace kreisel
