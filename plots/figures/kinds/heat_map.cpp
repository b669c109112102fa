// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/kinds/heat_map.hpp"

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

// Centimetres on the page, for letters of the standard size.
constexpr double name_character = 0.16, beside_names = 1.0, colours_width = 2.9;
constexpr double standard_place = 1.1, least_place = 0.3;

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

class HeatMap final : public HeatMapKind {
  public:
    std::vector<std::string> metrics = {"error.position"};
    std::string x = "h", y = "method", scale = "log";
    std::optional<double> width, height;    // of the page and of the axes of a map, mm
    double font_size = standard_font_size;  // points

    std::vector<std::string> drawn_metrics() const override { return metrics; }

    HeatMapData data(const Results& results) const override {
        const std::vector<ResultRow> rows = selected_rows(*this, results);
        std::vector<std::vector<Place>> all;
        Places xs, ys;
        for (const std::string& metric : metrics) {
            all.push_back(places_of(metric, rows));
            for (const Place& place : all.back()) { xs.add(place.x), ys.add(place.y); }
        }
        xs.sort(), ys.sort();
        HeatMapData drawn{axis_label(x), axis_label(y), xs.values(), ys.values(), scale == "log", {}};
        if (width) { drawn.width = *width / mm_per_cm; }
        if (height) { drawn.axes_height = *height / mm_per_cm; }
        drawn.font_size = font_size;
        for (std::size_t k = 0; k < metrics.size(); ++k) {
            if (all[k].empty()) { continue; }
            HeatMapData::Map map{metric_label(metrics[k], results.units), {}};
            for (const Place& place : all[k]) { map.places.push_back({xs.of(place.x), ys.of(place.y), place.value}); }
            drawn.maps.push_back(std::move(map));
        }
        if (drawn.maps.empty()) { throw FigureError(name + ": " + why_none(rows)); }
        return drawn;
    }

    void write(const Results& results, const std::filesystem::path& folder) const override {
        const HeatMapData drawn = data(results);
        std::string lines;  // a block for each metric
        for (const HeatMapData::Map& map : drawn.maps) {
            for (const auto& [x_place, y_place, value] : map.places) {
                lines += fmt::format("{} {} {} {:.1e}\n", x_place + 1, y_place + 1, value, value);
            }
            lines += "\n\n";
        }
        make_folder(folder / "plotdata");
        write_atomically(folder / "plotdata" / (name + ".dat"), lines);
        write_settings(drawn, folder);
    }

  private:
    std::string axis_value(const ResultRow& row, const CellNames& names, const std::string& axis) const {
        if (is_cell_value(axis)) { return cell_value(row, axis).value_or(""); }
        const bool is_size = std::find(sizes().begin(), sizes().end(), axis) != sizes().end();
        return is_size ? size_text(row, axis) : names.axis(row, axis);
    }
    std::string why_none(const std::vector<ResultRow>& rows) const {
        const std::string drawn = fmt::format("{}", fmt::join(metrics, " or "));
        const CellNames names(rows);
        bool some = false, negative = false;
        for (const ResultRow& row : rows) {
            if (axis_value(row, names, x).empty() || axis_value(row, names, y).empty()) { continue; }
            for (const std::string& metric : metrics) {
                const auto value = row.metrics.find(metric);
                if (value == row.metrics.end() || !std::isfinite(value->second)) { continue; }
                some = true, negative = negative || value->second < 0;
            }
        }
        if (!some) { return fmt::format("no selected cell has {} on these axes", drawn); }
        return fmt::format("all values of {} are 0{}, which no logarithmic scale shows; \"scale\": \"linear\" does",
                           drawn, negative ? " or below" : "");
    }
    // Of the cells that have the metric, and a value on both axes.
    std::vector<Place> places_of(const std::string& metric, const std::vector<ResultRow>& rows) const {
        const CellNames names(rows);
        std::vector<Place> places;
        for (const ResultRow& row : rows) {
            const auto value = row.metrics.find(metric);
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
        return places;
    }
    void write_settings(const HeatMapData& drawn, const std::filesystem::path& folder) const {
        Settings settings;
        settings.string("figure_name", name);
        settings.string("figure_title", enhanced_escape(title));
        settings.string("figure_note", enhanced_escape(note));
        settings.string("x_label", drawn.x_label);
        settings.string("y_label", drawn.y_label);
        settings.array("value_label", drawn.maps,
                       [](const HeatMapData::Map& map) { return gnuplot_quoted(map.label); });
        settings.number("log_scale", drawn.log ? 1 : 0);
        const auto escaped = [](const std::string& text) { return gnuplot_quoted(enhanced_escape(text)); };
        settings.array("x_value", drawn.x_values, escaped);
        settings.array("y_value", drawn.y_values, escaped);
        settings.number("font_size", font_size);
        write_widths(drawn, settings);
        settings.number("axes_height", drawn.axes_height.value_or(0));
        write_atomically(folder / "plotdata" / (name + ".gp"), settings.text());
    }
    void write_widths(const HeatMapData& drawn, Settings& settings) const {
        const double letters = font_size / standard_font_size, count = static_cast<double>(drawn.x_values.size());
        const double left = letters * (beside_names + name_character * static_cast<double>(widest(drawn.y_values)));
        const double right = letters * colours_width;
        const double place = drawn.width ? (*drawn.width - left - right) / count : letters * standard_place;
        if (place < least_place) {
            throw FigureError(fmt::format(
                "{}: {} places beside each other need a \"width\" of {:.0f} mm, got {:.0f} mm", name,
                drawn.x_values.size(), std::ceil(mm_per_cm * (left + right + count * least_place)), *width));
        }
        settings.number("left_cm", left);
        settings.number("right_cm", right);
        settings.number("place_width", place);
        settings.number("widest_x_cm", letters * name_character * static_cast<double>(widest(drawn.x_values)));
    }
    static std::string axis_label(const std::string& axis) {
        if (axis == "h") { return "h [s]"; }
        return enhanced_escape(is_cell_value(axis) ? axis.substr(axis.find('.') + 1) : axis);
    }
    static std::size_t widest(const std::vector<std::string>& values) {
        std::size_t width = 0;
        for (const std::string& value : values) { width = std::max(width, value.size()); }
        return width;
    }
};

}  // namespace

KREISEL_FIGURE(HeatMap,
               {.name = "heat_map",
                .summary = "metrics as colours of the places between two axes",
                .script = "heat_map",
                .keys = {figure_key("metric", &HeatMap::metrics,
                                    figure_value::metrics({"error.", "defect.", "invariant.", "structure."}),
                                    "what the colours show, a map each"),
                         figure_key("x", &HeatMap::x, map_axis(), "the axis to the right"),
                         figure_key("y", &HeatMap::y, map_axis(), "the axis upwards"),
                         figure_key("scale", &HeatMap::scale, figure_value::choice("scale", {"log", "linear"}),
                                    "the scale of colours"),
                         figure_key("width", &HeatMap::width, figure_value::page_width(), "width of the figure",
                                    "11 mm for each place and what the texts take"),
                         figure_key("height", &HeatMap::height, figure_value::between(10, 250, "a height in mm"),
                                    "height of the axes of a map", "6.2 mm for each place, 28 mm at least"),
                         figure_key("font_size", &HeatMap::font_size, figure_value::between(4, 20, "a size in points"),
                                    "size of letters on the page")}});

}  // namespace kreisel
