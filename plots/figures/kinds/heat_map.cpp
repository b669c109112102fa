// SPDX-License-Identifier: BSD-3-Clause
//
// A metric of each cell as the colour of a place between two axes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "plots/figures/cells/cell_value.hpp"
#include "plots/figures/cells/select.hpp"
#include "plots/figures/enhanced_text.hpp"
#include "plots/figures/kinds/curve_kind.hpp"
#include "plots/figures/settings.hpp"
#include "support/files.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

const std::vector<std::string>& sizes() {
    static const std::vector<std::string> all = {"h", "steps", "tolerance"};
    return all;
}

std::string size_text(const ResultRow& row, const std::string& axis) {
    if (axis == "steps") { return fmt::format("{}", row.steps); }
    const double size = axis == "h" ? row.h : row.tolerance;
    return size > 0 ? fmt::format("{:.3g}", size) : "";
}

bool is_number(const std::string& text) {
    char* end = nullptr;
    std::strtod(text.c_str(), &end);
    return !text.empty() && *end == '\0';
}

// Numbers by their size, other values as they come.
class Places {
  public:
    void add(const std::string& value) {
        if (std::find(values_.begin(), values_.end(), value) == values_.end()) { values_.push_back(value); }
    }
    void sort() {
        if (!std::all_of(values_.begin(), values_.end(), is_number)) { return; }
        const auto number = [](const std::string& text) { return std::strtod(text.c_str(), nullptr); };
        std::stable_sort(values_.begin(), values_.end(),
                         [&](const std::string& a, const std::string& b) { return number(a) < number(b); });
    }
    std::size_t of(const std::string& value) const {
        return static_cast<std::size_t>(std::find(values_.begin(), values_.end(), value) - values_.begin());
    }
    const std::vector<std::string>& values() const { return values_; }

  private:
    std::vector<std::string> values_;
};

struct Place {
    std::string x, y;
    double value = 0;
};

figure_value::Type<std::string> map_axis() {
    auto names = CellNames::figure_axes();
    names.insert(names.end(), sizes().begin(), sizes().end());
    const std::string expected = "an axis (" + listed(names) + R"(, or "parameter.NAME", "option.NAME", ...))";
    nlohmann::ordered_json schema = {{"type", "string"}, {"maxLength", 200}};
    schema["anyOf"] = {{{"enum", names}}, {{"pattern", "^(parameter|option|projection_option)[.]."}}};
    return {expected, [=] { return schema; },
            [=](const Node& node) -> std::optional<std::string> {
                auto axis = node.text(expected);
                const bool known =
                    axis && (is_cell_value(*axis) || std::find(names.begin(), names.end(), *axis) != names.end());
                if (axis && !known) {
                    node.mismatch(expected, nearest_name(*axis, names));
                    return std::nullopt;
                }
                return axis;
            }};
}

class HeatMap final : public Figure {
  public:
    std::vector<std::string> metrics = {"error.position"};
    std::string x = "h", y = "method", scale = "log";

    std::vector<std::string> drawn_metrics() const override { return metrics; }

    void write(const Results& results, const std::filesystem::path& folder) const override {
        if (metrics.size() != 1) { throw FigureError(name + ": a heat map shows one metric"); }
        const std::vector<Place> places = places_of(results);
        Places xs, ys;
        for (const Place& place : places) { xs.add(place.x), ys.add(place.y); }
        xs.sort(), ys.sort();
        std::string lines;
        for (const Place& place : places) {
            lines += fmt::format("{} {} {} {:.1e}\n", xs.of(place.x) + 1, ys.of(place.y) + 1, place.value, place.value);
        }
        make_folder(folder / "plotdata");
        write_atomically(folder / "plotdata" / (name + ".dat"), lines);
        write_settings(xs, ys, results, folder);
    }

  private:
    std::string axis_value(const ResultRow& row, const CellNames& names, const std::string& axis) const {
        if (is_cell_value(axis)) { return cell_value(row, axis).value_or(""); }
        const bool is_size = std::find(sizes().begin(), sizes().end(), axis) != sizes().end();
        return is_size ? size_text(row, axis) : names.axis(row, axis);
    }
    // Of the cells that have the metric, and a value on both axes.
    std::vector<Place> places_of(const Results& results) const {
        const std::vector<ResultRow> rows = selected_rows(*this, results);
        const CellNames names(rows);
        std::vector<Place> places;
        for (const ResultRow& row : rows) {
            const auto value = row.metrics.find(metrics.front());
            Place place{axis_value(row, names, x), axis_value(row, names, y)};
            if (value == row.metrics.end() || place.x.empty() || place.y.empty()) { continue; }
            const bool taken = std::any_of(places.begin(), places.end(), [&](const Place& other) {
                return other.x == place.x && other.y == place.y;
            });
            if (taken) {
                throw FigureError(fmt::format("{}: several cells have {} {} and {} {}; \"select\" leaves one", name, x,
                                              place.x, y, place.y));
            }
            place.value = value->second;
            if (std::isfinite(place.value) && (scale == "linear" || place.value > 0)) { places.push_back(place); }
        }
        if (places.empty()) {
            throw FigureError(fmt::format("{}: no selected cell has {} on these axes", name, metrics.front()));
        }
        return places;
    }
    void write_settings(const Places& xs, const Places& ys, const Results& results,
                        const std::filesystem::path& folder) const {
        Settings settings;
        settings.string("figure_name", name);
        settings.string("figure_title", enhanced_escape(title));
        settings.string("figure_note", enhanced_escape(note));
        settings.string("x_label", axis_label(x));
        settings.string("y_label", axis_label(y));
        settings.string("value_label", metric_label(metrics.front(), results.units));
        settings.number("log_scale", scale == "log" ? 1 : 0);
        const auto escaped = [](const std::string& text) { return gnuplot_quoted(enhanced_escape(text)); };
        settings.array("x_value", xs.values(), escaped);
        settings.array("y_value", ys.values(), escaped);
        settings.number("widest_x", static_cast<double>(widest(xs)));
        settings.number("widest_y", static_cast<double>(widest(ys)));
        write_atomically(folder / "plotdata" / (name + ".gp"), settings.text());
    }
    static std::string axis_label(const std::string& axis) {
        if (axis == "h") { return "h [s]"; }
        return enhanced_escape(is_cell_value(axis) ? axis.substr(axis.find('.') + 1) : axis);
    }
    static std::size_t widest(const Places& places) {
        std::size_t width = 0;
        for (const std::string& value : places.values()) { width = std::max(width, value.size()); }
        return width;
    }
};

}  // namespace

KREISEL_FIGURE(HeatMap, {.name = "heat_map",
                         .summary = "a metric as the colour of a place between two axes",
                         .script = "heat_map",
                         .keys = {figure_key("metric", &HeatMap::metrics,
                                             figure_value::metrics({"error.", "defect.", "invariant.", "structure."}),
                                             "what the colour shows: one"),
                                  figure_key("x", &HeatMap::x, map_axis(), "the axis to the right"),
                                  figure_key("y", &HeatMap::y, map_axis(), "the axis upwards"),
                                  figure_key("scale", &HeatMap::scale, figure_value::choice("scale", {"log", "linear"}),
                                             "the scale of colours")}});

}  // namespace kreisel
