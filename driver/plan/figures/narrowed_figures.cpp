// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/figures/narrowed_figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "driver/plan/figures/figures.hpp"
#include "driver/plan/figures/selected_names.hpp"
#include "plots/figures/cells/cell_value.hpp"
#include "records/json/diagnostics.hpp"

namespace kreisel {

namespace {

using nlohmann::json;

// The figures of a plan, one below the other, whether it has one or a list.
json listed_figures(const Plan& plan) {
    json figures = json::parse(plan.config.figure);
    return figures.is_array() ? figures : json::array({figures});
}

// One figure of the config as it is narrowed.
class Narrowed {
  public:
    Narrowed(json figure, const std::vector<std::string>& metrics, const Engine& engine, const Plan& plan)
        : figure_(std::move(figure)), metrics_(metrics), engine_(engine), plan_(plan) {
        narrow_selection();
        if (!is_left_out()) { check(); }
    }
    const json& figure() const { return figure_; }
    bool is_left_out() const { return !reason_.empty(); }
    /// Empty where the figure is as written.
    std::string warning() const {
        const std::string name = in_quotes(figure_.value("name", plan_.config.name));
        if (is_left_out()) { return fmt::format("figure {} is left out: {}", name, reason_); }
        if (missing_.empty()) { return ""; }
        return fmt::format("figure {} is without {}, which --filter took away", name, fmt::join(missing_, ", "));
    }

  private:
    void narrow_selection() {
        if (!figure_.contains("select")) { return; }
        for (const auto& entry : figure_["select"].items()) {
            if (is_cell_value(entry.key()) || entry.key() == "steps" || entry.key() == "tolerance") { continue; }
            narrow_axis(entry.key(), entry.value());
        }
    }

    void narrow_axis(const std::string& key, json& values) {
        const auto known = selectable(key, plan_.config);
        json left = json::array();
        std::vector<std::string> taken;
        for (const json& value : values.is_array() ? values : json::array({values})) {
            const auto& name = value.get_ref<const std::string&>();
            const bool stays = has_options(key, name) || std::count(known.begin(), known.end(), name) > 0;
            if (stays) { left.push_back(value); }
            if (!stays) { taken.push_back("the " + key + " " + in_quotes(name)); }
        }
        if (left.empty()) { reason_ = fmt::format("--filter took {} away", fmt::join(taken, ", ")); }
        missing_.insert(missing_.end(), taken.begin(), taken.end());
        if (!taken.empty()) { values = left; }
    }

    // What is wrong with it, as if the config had been written so.
    std::vector<Issue> issues() const {
        const Document document{.file = "figure", .text = "", .value = {{"figure", figure_}}};
        Diagnostics sink(document);
        check_figures(document, plan_, metrics_, engine_, sink);
        if (sink.empty()) { check_selections(document, plan_, sink); }
        return sink.issues();
    }

    void check() {
        const std::vector<Issue> found = issues();
        std::for_each(found.rbegin(), found.rend(), [&](const Issue& issue) {
            if (issue.rule == Rule::figure_curve) { take_out(issue); }
        });
        for (const char* key : {"legend", "order"}) {
            if (figure_.contains(key) && figure_[key].empty()) { figure_.erase(key); }
        }
        const auto other = std::find_if(found.begin(), found.end(),
                                        [](const Issue& issue) { return issue.rule != Rule::figure_curve; });
        if (other == found.end()) { return; }
        reason_ = fmt::format("of what --filter leaves it can show nothing: expected {}, got {}", other->expected,
                              other->got);
    }

    // A name of a curve: a key of "legend", an entry of "order". From the last to the first, so that places hold.
    void take_out(const Issue& issue) {
        const json::json_pointer place(issue.pointer.substr(std::string("/figure").size()));
        json& names = figure_.at(place.parent_pointer());
        if (names.is_array()) {
            names.erase(std::stoul(place.back()));
        } else {
            names.erase(place.back());
        }
        const std::string curve = "the curve " + issue.got;  // in "legend" and in "order" it is the same
        if (std::count(missing_.begin(), missing_.end(), curve) == 0) { missing_.push_back(curve); }
    }

    json figure_;
    const std::vector<std::string>& metrics_;
    const Engine& engine_;
    const Plan& plan_;
    std::vector<std::string> missing_;
    std::string reason_;
};

}  // namespace

void check_filtered_figures(const Document& document, const Plan& plan, const std::vector<std::string>& metrics,
                            const Engine& engine, Diagnostics& sink) {
    const Config& whole = *plan.config.whole;
    if (whole.problems.size() == plan.config.problems.size()) {
        return check_figures(document, plan, metrics, engine, sink);
    }
    for (const auto& figure : figures_in(document, plan)) { check_selected_names(document, whole, *figure, sink); }
}

void narrow_figures(const std::vector<std::string>& metrics, const Engine& engine, Plan& plan) {
    if (plan.config.figure.empty()) { return; }
    json left = json::array();
    for (const json& figure : listed_figures(plan)) {
        const Narrowed narrowed(figure, metrics, engine, plan);
        if (!narrowed.is_left_out()) { left.push_back(narrowed.figure()); }
        if (!narrowed.warning().empty()) { plan.warnings.push_back(narrowed.warning()); }
    }
    plan.config.figure = left.dump();
}

}  // namespace kreisel
