// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "driver/plan/curve_names.hpp"
#include "plots/figures/cells/cell_value.hpp"
#include "plots/figures/kind.hpp"
#include "plots/figures/spec.hpp"
#include "records/json/diagnostics.hpp"
#include "records/metrics/catalogue.hpp"
#include "support/nearest.hpp"
#include "support/pattern.hpp"

namespace kreisel {

namespace {

bool in_list(const std::vector<std::string>& list, const std::string& value) {
    return std::find(list.begin(), list.end(), value) != list.end();
}

std::vector<std::string> entry_names(const std::vector<OptionedEntry>& entries) {
    std::vector<std::string> names;
    names.reserve(entries.size());
    for (const OptionedEntry& entry : entries) { names.push_back(entry.name); }
    return names;
}

// The values `select` may name under a key; nothing if the values are not known before the run (names with options).
std::vector<std::string> selectable(const std::string& key, const Config& config) {
    std::vector<std::string> values;
    if (key == "steps") {
        for (const long steps : config.steps) { values.push_back(fmt::format("{}", steps)); }
    }
    if (key == "results") { values = {config.name}; }
    if (key == "problem") {
        for (const ProblemPoint& problem : config.problems) {
            values.insert(values.end(), {problem.label(), problem.series_label(), problem.name()});
        }
    }
    if (key == "tolerance") {
        for (const double tolerance : config.tolerances) { values.push_back(fmt::format("{}", tolerance)); }
    }
    if (key == "formulation") { values = config.formulations; }
    if (key == "precision") { values = config.precisions; }
    if (key == "method") { values = entry_names(config.methods); }
    if (key == "projection") { values = entry_names(config.projections); }
    return values;
}

bool is_selected(const Figure& figure, const std::string& key, const std::vector<std::string>& names) {
    const auto wanted = figure.select.find(key);
    if (wanted == figure.select.end()) { return true; }
    return std::any_of(wanted->second.begin(), wanted->second.end(), [&](const std::string& value) {
        // What a method with options is called is not known before the run.
        const bool with_options = (key == "method" || key == "projection") && value.find(' ') != std::string::npos;
        return with_options || in_list(names, value);
    });
}

// Whether it selects by parameters or options.
bool names_cell_values(const Figure& figure) {
    return std::any_of(figure.select.begin(), figure.select.end(),
                       [](const auto& entry) { return is_cell_value(entry.first); });
}

ResultRow planned_row(const PlannedCell& cell) {
    return result_row({.identity = cell.identity(), .outcome = {}, .times = {}});
}

bool fits_values(const Figure& figure, const PlannedCell& cell) {
    if (!names_cell_values(figure)) { return true; }
    const ResultRow row = planned_row(cell);
    return std::all_of(figure.select.begin(), figure.select.end(), [&](const auto& entry) {
        const auto& [key, values] = entry;
        const auto value = is_cell_value(key) ? cell_value(row, key) : std::nullopt;
        return !is_cell_value(key) || (value && in_list(values, *value));
    });
}

bool fits(const Figure& figure, const PlannedCell& cell) {
    const CellIdentity& of = cell.run->identity;
    return is_selected(figure, "problem", {cell.label(), of.series, of.problem}) &&
           is_selected(figure, "formulation", {of.formulation}) && is_selected(figure, "method", {of.method}) &&
           is_selected(figure, "projection", {of.projection}) && is_selected(figure, "precision", {of.precision}) &&
           is_selected(figure, "steps", {fmt::format("{}", cell.steps)}) &&
           is_selected(figure, "tolerance", {fmt::format("{}", cell.tolerance)}) && fits_values(figure, cell);
}

// By name, the parameters and options of the cells that are run.
std::map<std::string, std::set<std::string>> values_of_cells(const Plan& plan, const Figure& figure) {
    std::map<std::string, std::set<std::string>> known;
    if (!names_cell_values(figure)) { return known; }
    for (const PlannedCell& cell : plan.cells) {
        const ResultRow row = planned_row(cell);
        for (const auto& [key, wanted] : figure.select) {
            if (!is_cell_value(key)) { continue; }
            if (const auto value = cell_value(row, key)) { known[key].insert(*value); }
        }
    }
    return known;
}

std::vector<std::string> bodies_of(const Figure& figure, const Config& config, const Engine& engine) {
    std::vector<std::string> names;
    for (const ProblemPoint& problem : config.problems) {
        if (!is_selected(figure, "problem", {problem.label(), problem.series_label(), problem.name()})) { continue; }
        for (const BodyGeometry& body : engine.geometry(problem.name(), problem.parameters()).bodies) {
            if (!in_list(names, body.name)) { names.push_back(body.name); }
        }
    }
    return names;
}

class FigureCheck {
  public:
    FigureCheck(const Document& document, const Plan& plan, const std::vector<std::string>& metrics,
                const Engine& engine, Diagnostics& sink)
        : document_(document), config_(plan.config), metrics_(metrics), engine_(engine), sink_(sink) {}

    void check(const Figure& figure) {
        const FigureKind& kind = *find_figure_kind(figure.kind);
        const std::vector<std::string> drawn = figure.drawn_metrics();
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            if (kind.metrics.empty()) { check_metric(drawn[i], place(figure.pointer + "/metric", i)); }
        }
        check_axes(figure, kind);
        check_body(figure);
        check_until(figure);
        for (const auto& [key, values] : figure.select) {
            for (std::size_t i = 0; i < values.size(); ++i) { check_selection(figure, key, values[i], i); }
        }
    }

  private:
    void refuse(Rule rule, const std::string& pointer, const std::string& expected, const std::string& got,
                const std::string& suggestion = "") {
        sink_.add({.pointer = pointer, .expected = expected, .got = got, .suggestion = suggestion, .rule = rule});
    }

    // The place of entry i under a key that holds one value or a list, or is left out.
    std::string place(const std::string& pointer, std::size_t i) const {
        const nlohmann::json::json_pointer path(pointer);
        if (!document_.value.contains(path)) { return pointer.substr(0, pointer.rfind('/')); }
        return document_.value.at(path).is_array() ? fmt::format("{}/{}", pointer, i) : pointer;
    }

    void check_metric(const std::string& metric, const std::string& pointer) {
        if (!in_list(metrics_, metric)) {
            refuse(Rule::figure_metric, pointer, "a metric of these problems (see kreisel list metrics)",
                   in_quotes(metric), nearest_name(metric, metrics_));
        } else if (!matches_any(config_.metrics, metric)) {
            refuse(Rule::figure_metric, pointer,
                   "a metric that this experiment measures (key \"metrics\"; here " +
                       (config_.metrics.empty() ? "none" : listed(config_.metrics)) + ")",
                   in_quotes(metric));
        } else if (is_largest_error(metric) && config_.samples == 0) {
            refuse(Rule::figure_metric, pointer,
                   "a metric that is measured without samples (a maximum over them needs \"output\": {\"samples\": "
                   "K})",
                   in_quotes(metric));
        }
    }

    // Two keys of this name choose what is drawn to the right and upwards.
    void check_axes(const Figure& figure, const FigureKind& kind) {
        std::vector<nlohmann::ordered_json> axes;
        for (const FigureKey& key : kind.keys) {
            if (key.name == "x" || key.name == "y") { axes.push_back(key.value(figure)); }
        }
        if (axes.size() < 2 || axes.front() != axes.back()) { return; }
        refuse(Rule::each_once, place(figure.pointer + "/y", 0), "another axis than that of x",
               axes.back().dump() + " again");
    }

    void check_body(const Figure& figure) {
        if (figure.drawn_body().empty()) { return; }
        const std::vector<std::string> bodies = bodies_of(figure, config_, engine_);
        if (in_list(bodies, figure.drawn_body())) { return; }
        refuse(Rule::figure_body, figure.pointer + "/body", "a body of the problem (" + listed(bodies) + ")",
               in_quotes(figure.drawn_body()), nearest_name(figure.drawn_body(), bodies));
    }

    void check_until(const Figure& figure) {
        if (figure.drawn_until().value_or(0) <= config_.t_end) { return; }
        refuse(Rule::figure_until, figure.pointer + "/until",
               fmt::format("a time up to the end of the run, {} s", config_.t_end),
               fmt::format("{}", *figure.drawn_until()));
    }

    void check_selection(const Figure& figure, const std::string& key, const std::string& value, std::size_t i) {
        if (is_cell_value(key)) { return; }  // known when the cells are
        const auto values = selectable(key, config_);
        const bool with_options = (key == "method" || key == "projection") && value.find(' ') != std::string::npos;
        if (in_list(values, value) || with_options) { return; }
        refuse(Rule::figure_selection, place(fmt::format("{}/select/{}", figure.pointer, key), i),
               key == "steps"
                   ? fmt::format("one of the numbers of steps of this experiment ({})", fmt::join(values, ", "))
                   : fmt::format("a {} of this experiment", key),
               key == "steps" || key == "tolerance" ? value : in_quotes(value), nearest_name(value, values));
    }

    const Document& document_;
    const Config& config_;
    const std::vector<std::string>& metrics_;
    const Engine& engine_;
    Diagnostics& sink_;
};

// Their shape was checked when the config was read.
std::vector<std::unique_ptr<Figure>> figures_in(const Document& document, const Plan& plan) {
    if (plan.config.figure.empty()) { return {}; }
    Diagnostics quiet(document);
    return read_figures(Node(document.value.at("figure"), "/figure", quiet), plan.config.name);
}

// False, with errors, where `select` names parameters or options, or values of these, that no cell has.
bool check_cell_values(const Figure& figure, const Plan& plan, Diagnostics& sink) {
    const auto known = values_of_cells(plan, figure);
    bool all = true;
    for (const auto& [key, wanted] : figure.select) {
        const auto values = known.find(key);
        for (const std::string& value : wanted) {
            if (!is_cell_value(key) || (values != known.end() && values->second.contains(value))) { continue; }
            all = false;
            const std::string expected =
                values == known.end()
                    ? "a parameter or an option of cells of this experiment (see kreisel info)"
                    : fmt::format("a value of it in this experiment ({})", fmt::join(values->second, ", "));
            sink.add({.pointer = figure.pointer + "/select/" + key,
                      .expected = expected,
                      .got = values == known.end() ? in_quotes(key) : value,
                      .rule = Rule::figure_selection});
        }
    }
    return all;
}

// The cells that a figure may draw.
std::vector<ResultRow> drawn_rows(const Figure& figure, const Plan& plan) {
    std::vector<ResultRow> rows;
    for (const PlannedCell& cell : plan.cells) {
        if (cell.skip_reason().empty() && fits(figure, cell)) { rows.push_back(planned_row(cell)); }
    }
    return rows;
}

}  // namespace

void check_figures(const Document& document, const Plan& plan, const std::vector<std::string>& metrics,
                   const Engine& engine, Diagnostics& sink) {
    FigureCheck check(document, plan, metrics, engine, sink);
    for (const auto& figure : figures_in(document, plan)) { check.check(*figure); }
}

void check_selections(const Document& document, const Plan& plan, Diagnostics& sink) {
    if (plan.skipped() == plan.cells.size()) { return; }
    for (const auto& figure : figures_in(document, plan)) {
        if (names_curves(*figure)) { check_curve_names(*figure, drawn_rows(*figure, plan), sink); }
        const bool some = std::any_of(plan.cells.begin(), plan.cells.end(), [&](const PlannedCell& cell) {
            return cell.skip_reason().empty() && fits(*figure, cell);
        });
        if (some || figure->select.empty() || !check_cell_values(*figure, plan, sink)) { continue; }
        sink.add({.pointer = figure->pointer + "/select",
                  .expected = "a choice that fits a cell which is run (see kreisel plan)",
                  .got = "one that fits none",
                  .rule = Rule::figure_selection});
    }
}

}  // namespace kreisel
