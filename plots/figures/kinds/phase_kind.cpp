// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/kinds/phase_kind.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plots/figures/cells/legends.hpp"
#include "plots/figures/cells/select.hpp"
#include "records/reading/trajectory_table.hpp"

namespace kreisel {

namespace {

std::string quantity_label(const std::string& quantity, const std::string& unit) {
    const std::string symbol = quantity.substr(0, quantity.size() - 1);
    return fmt::format("{}_{} [{}]", symbol == "omega" ? "ω" : symbol, quantity.back(), enhanced_escape(unit));
}

}  // namespace

const std::vector<std::string>& phase_quantities() {
    static const std::vector<std::string> all = {"x1", "x2", "x3", "v1", "v2", "v3", "omega1", "omega2", "omega3"};
    return all;
}

figure_value::Type<std::string> phase_quantity() { return figure_value::choice("quantity", phase_quantities()); }

const std::vector<double>& PhaseKind::column(const TrajectoryTable& samples, const std::string& prefix,
                                             const std::string& quantity) const {
    const auto* found = samples.find(prefix + quantity);
    if (found == nullptr) { throw FigureError(fmt::format("{}: the trajectory has no {}{}", name, prefix, quantity)); }
    return *found;
}

PanelFigure PhaseKind::make_panels(const Results& results) const {
    const auto rows_of = [&](const FigureSpec& of) { return with_samples(selected_rows(of, results, true), of); };
    FigureSpec whole = *this;
    whole.select.clear();
    const std::vector<ResultRow> rows = rows_of(*this), all = rows_of(whole);
    const CellNames names(rows);
    const Legends legends(rows, names, "", true);
    Styles styles(all, legends);
    Panel panel;
    for (const ResultRow& row : rows) {
        const TrajectoryTable samples = samples_until(until, row);
        const std::string prefix = body_of(*this, body, samples) + ".";
        panel.x_label = quantity_label(x, samples.unit(prefix + x));
        panel.y_label = quantity_label(y, samples.unit(prefix + y));
        const std::string called = legends.name(row);
        panel.curves.push_back({label_of(called), points_of(samples, prefix), styles.of(row), {}, called});
    }
    const bool nothing =
        std::all_of(panel.curves.begin(), panel.curves.end(), [](const Curve& curve) { return curve.points.empty(); });
    if (nothing) { throw FigureError(fmt::format("{}: {}", name, lacking())); }
    return {name, enhanced_escape(title), {panel}, columns};
}

std::vector<FigureKey> phase_keys() {
    auto keys = look_keys();
    keys.insert(
        keys.begin(),
        {figure_key("body", &PhaseKind::body, figure_value::text("the name of a body"), "which body", "the first"),
         figure_key("x", &PhaseKind::x, phase_quantity(), "what the x axis shows"),
         figure_key("y", &PhaseKind::y, phase_quantity(), "what the y axis shows"),
         figure_key("until", &PhaseKind::until, figure_value::positive("a time greater than 0, s"), "up to which time",
                    "all")});
    return keys;
}

}  // namespace kreisel
