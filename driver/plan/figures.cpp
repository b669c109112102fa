// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/figures.hpp"

#include <fmt/format.h>

#include <algorithm>

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
    if (key == "problem") {
        for (const ProblemEntry& problem : config.problems) {
            values.insert(values.end(), {problem.label, problem.series, problem.name});
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

std::vector<std::string> timed_figures() {
    std::vector<std::string> names;
    for (const FigureKind& kind : figure_kinds()) {
        if (kind.draws == FigureData::timed_cells) { names.push_back(kind.name); }
    }
    return names;
}

class FigureCheck {
  public:
    FigureCheck(const Document& document, const Plan& plan, const std::vector<std::string>& metrics, Diagnostics& sink)
        : document_(document), config_(plan.config), metrics_(metrics), sink_(sink) {}

    void check(const Figure& figure) {
        const FigureKind& kind = *find_figure_kind(figure.kind);
        if ((kind.draws == FigureData::timed_cells) != config_.is_timed()) { return refuse_kind(figure); }
        if (kind.draws == FigureData::samples && config_.samples == 0) {
            sink_.add({figure.pointer + "/kind",
                       "an experiment that stores samples (\"output\": {\"samples\": K}), since this figure draws them",
                       fmt::format("{} and no samples", in_quotes(figure.kind))});
        }
        const std::vector<std::string> drawn = figure.drawn_metrics();
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            check_metric(kind, drawn[i], place(figure.pointer + "/metric", i));
        }
        check_abscissa(kind, figure);
        for (const auto& [key, values] : figure.select) {
            for (std::size_t i = 0; i < values.size(); ++i) { check_selection(figure, key, values[i], i); }
        }
    }

  private:
    // The place of entry i under a key that holds one value or a list, or is left out.
    std::string place(const std::string& pointer, std::size_t i) const {
        const nlohmann::json::json_pointer path(pointer);
        if (!document_.value.contains(path)) { return pointer.substr(0, pointer.rfind('/')); }
        return document_.value.at(path).is_array() ? fmt::format("{}/{}", pointer, i) : pointer;
    }

    void refuse_kind(const Figure& figure) {
        const std::string kind = in_quotes(figure.kind);
        sink_.add({figure.pointer + "/kind",
                   config_.is_timed() ? listed(timed_figures()) + ", the figure of an experiment of this kind"
                                      : "a figure of states or errors (" + kind + " draws experiments of that kind)",
                   kind});
    }

    void check_metric(const FigureKind& kind, const std::string& metric, const std::string& pointer) {
        if (!kind.metrics.empty()) { return check_own_metric(kind, metric, pointer); }
        if (!in_list(metrics_, metric)) {
            sink_.add({pointer, "a metric of these problems (see kreisel list metrics)", in_quotes(metric),
                       nearest_name(metric, metrics_)});
        } else if (!matches_any(config_.metrics, metric)) {
            sink_.add({pointer,
                       "a metric that this experiment measures (key \"metrics\"; here " +
                           (config_.metrics.empty() ? "none" : listed(config_.metrics)) + ")",
                       in_quotes(metric)});
        } else if (is_largest_error(metric) && config_.samples == 0) {
            sink_.add({pointer,
                       "a metric that is measured without samples (a maximum over them needs \"output\": {\"samples\": "
                       "K})",
                       in_quotes(metric)});
        }
    }

    void check_own_metric(const FigureKind& kind, const std::string& metric, const std::string& pointer) {
        if (in_list(kind.metrics, metric)) { return; }
        sink_.add({pointer, "one of " + listed(kind.metrics), in_quotes(metric), nearest_name(metric, kind.metrics)});
    }

    // Whether some cell of the experiment will have what is drawn against.
    void check_abscissa(const FigureKind& kind, const Figure& figure) {
        const std::string x = figure.drawn_against();
        const bool sampled = kind.draws == FigureData::samples;
        const bool counted = config_.is_repeated() || (!config_.tolerances.empty() && !sampled);
        std::string expected;
        if (x == "cpu" && !config_.is_repeated()) { expected = "a kind of experiment that measures it"; }
        if (in_list({"exponentials", "brackets", "newton_iterations"}, x) && !counted) {
            expected = "a kind of experiment that counts them, or tolerances";
        }
        if (sampled && !x.empty() && !config_.is_repeated()) {
            expected = "a kind of experiment whose samples tell their cost (work_precision)";
        }
        if (in_list({"tolerance", "rejected"}, x) && config_.tolerances.empty()) {
            expected = "tolerances in \"time\"";
        }
        if (x == "h" && config_.steps.empty()) { expected = "steps of one size in \"time\""; }
        if (!expected.empty()) { sink_.add({place(figure.pointer + "/x", 0), expected, in_quotes(x)}); }
    }

    void check_selection(const Figure& figure, const std::string& key, const std::string& value, std::size_t i) {
        const auto values = selectable(key, config_);
        const bool with_options = (key == "method" || key == "projection") && value.find(' ') != std::string::npos;
        if (in_list(values, value) || with_options) { return; }
        sink_.add({place(fmt::format("{}/select/{}", figure.pointer, key), i),
                   fmt::format("a {} of this experiment", key),
                   key == "steps" || key == "tolerance" ? value : in_quotes(value), nearest_name(value, values)});
    }

    const Document& document_;
    const Config& config_;
    const std::vector<std::string>& metrics_;
    Diagnostics& sink_;
};

}  // namespace

void check_figures(const Document& document, const Plan& plan, const std::vector<std::string>& metrics,
                   Diagnostics& sink) {
    if (plan.config.figure.empty()) { return; }
    Diagnostics quiet(document);  // the shape was checked when the config was read
    const auto figures = read_figures(Node(document.value.at("figure"), "/figure", quiet), plan.config.name);
    FigureCheck check(document, plan, metrics, sink);
    for (const auto& figure : figures) { check.check(*figure); }
}

}  // namespace kreisel
