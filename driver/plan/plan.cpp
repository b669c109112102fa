// SPDX-License-Identifier: BSD-3-Clause
#include "driver/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "driver/plan/begins.hpp"
#include "driver/plan/cells/crossing.hpp"
#include "driver/plan/figures/figures.hpp"
#include "driver/plan/figures/narrowed_figures.hpp"
#include "driver/plan/metrics.hpp"
#include "records/json/diagnostics.hpp"
#include "records/kinds/kind.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

// For a name that does not exist, the nearest one that does.
std::string suggestion(const ParameterError& error) {
    const std::string nearest = error.known.empty() ? "" : nearest_name(error.written, error.known);
    return nearest.empty() ? "" : "; did you mean " + in_quotes(nearest) + "?";
}

// What problems warn of. What several values of one list have in common is said once.
class Warnings {
  public:
    void add(const ProblemPoint& problem, const std::string& text) {
        const auto [known, is_new] = places_.emplace(std::pair(problem.series_label(), text), said_.size());
        if (is_new) { said_.push_back({problem, text}); }
        Said& said = said_[known->second];
        if (said.problems == 0 || said.last != problem) { ++said.problems; }
        said.last = problem;
    }

    std::vector<std::string> texts() const {
        std::vector<std::string> all;
        for (const Said& said : said_) {
            const std::string others = said.problems == 1 ? "" : fmt::format(" and {} more", said.problems - 1);
            all.push_back(fmt::format("{}{}: {}", said.first.label(), others, said.text));
        }
        return all;
    }

  private:
    struct Said {
        ProblemPoint first;
        std::string text;
        ProblemPoint last = first;
        std::size_t problems = 0;
    };
    std::vector<Said> said_;
    std::map<std::pair<std::string, std::string>, std::size_t> places_;
};

// A program may be built for one precision only.
void check_precisions(const Document& document, const Config& config, const Engines& engines, Diagnostics& sink) {
    const bool wants_quad = std::count(config.precisions.begin(), config.precisions.end(), "quad") > 0;
    if (!wants_quad || engines.has_quad()) { return; }
    const auto& written = document.value.at("precision");
    const auto place = std::find(written.begin(), written.end(), "quad") - written.begin();
    sink.add({.pointer = written.is_array() ? fmt::format("/precision/{}", place) : "/precision",
              .expected = "\"double\": this program is built without quad precision (KREISEL_BINARY128=OFF)",
              .got = in_quotes("quad"),
              .rule = Rule::quad});
}

// Asks the engines about the problems, each in every formulation and precision.
class Summaries {
  public:
    Summaries(const Config& config, const Engines& engines, Diagnostics& sink, Plan& plan)
        : config_(config), engines_(engines), sink_(sink), plan_(plan) {}

    void add(const ProblemPoint& problem) {
        const ParameterValues parameters = problem.parameters();
        std::set<std::string> said;
        for (const std::string& formulation : config_.formulations) {
            SystemSummary last;
            for (const std::string& precision : config_.precisions) {
                try {
                    last = engines_.of(precision).summary(problem.name(), parameters, formulation);
                    for (const std::string& warning : last.warnings) { warnings_.add(problem, warning); }
                } catch (const ParameterError& error) {
                    if (said.insert(error.path + error.what()).second) { report(problem, error); }
                }
            }
            plan_.systems.add(std::move(last));
        }
    }
    std::vector<std::string> warnings() const { return warnings_.texts(); }

  private:
    void report(const ProblemPoint& problem, const ParameterError& error) {
        sink_.add_sentence(problem.parameter_pointer(error.path), error.what() + suggestion(error), Rule::model);
    }

    const Config& config_;
    const Engines& engines_;
    Diagnostics& sink_;
    Plan& plan_;
    Warnings warnings_;
};

// Builds the system of each problem in each formulation and precision; an inadmissible start or inertia is an error.
void summarise(const Config& config, const Engines& engines, Diagnostics& sink, Plan& plan) {
    Summaries summaries(config, engines, sink, plan);
    for (const ProblemPoint& problem : config.problems) { summaries.add(problem); }
    plan.warnings = summaries.warnings();
}

// Plain names of metrics that the config has without its filters only. What is wrong with the problems that a filter
// took away is of no interest.
std::vector<std::string> taken_metrics(const std::vector<std::string>& metrics, const Config& config,
                                       const Engines& engines, const Document& document) {
    std::vector<std::string> unknown = unknown_metrics(metrics, config);
    if (!config.whole || unknown.empty()) { return {}; }
    Plan whole;
    Diagnostics unheard(document);
    summarise(*config.whole, engines, unheard, whole);
    const std::vector<std::string> known = known_metrics(whole);
    std::erase_if(unknown,
                  [&](const auto& name) { return std::find(known.begin(), known.end(), name) == known.end(); });
    return unknown;
}

void warn(Plan& plan) {
    plan.warnings.insert(plan.warnings.begin(), plan.config.warnings.begin(), plan.config.warnings.end());
    if (plan.skipped() == plan.cells.size()) {
        plan.warnings.emplace_back("every cell of this config is skipped: nothing will be computed");
    }
    const ExperimentKind& kind = *find_experiment_kind(plan.config.kind);
    for (std::string& advice : kind.advise({plan.config.metrics, plan.config.samples})) {
        plan.warnings.push_back(std::move(advice));
    }
}

}  // namespace

std::size_t Plan::skipped() const {
    return static_cast<std::size_t>(
        std::count_if(cells.begin(), cells.end(), [](const PlannedCell& cell) { return !cell.skip_reason().empty(); }));
}

Plan make_plan(const Document& document, const Config& config, const Engines& engines) {
    Diagnostics sink(document);
    Plan plan;
    plan.config = config;
    check_precisions(document, config, engines, sink);
    sink.raise();
    summarise(config, engines, sink, plan);
    sink.raise();
    check_begins(engines, sink, plan);
    const auto metrics = known_metrics(plan);
    check_metrics(metrics, taken_metrics(metrics, config, engines, document), sink, plan);
    const auto check = config.whole ? check_filtered_figures : check_figures;
    check(document, plan, metrics, engines.binary64, sink);
    cross_axes(engines, sink, plan);
    sink.raise();
    if (config.whole) {
        narrow_figures(metrics, engines.binary64, plan);
    } else {
        check_selections(document, plan, sink);
    }
    sink.raise();
    warn(plan);
    return plan;
}

Plan plan_of(const Document& document, const Engines& engines) {
    return make_plan(document, read_config(document, Catalogue(engines.binary64)), engines);
}

}  // namespace kreisel
