// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "driver/cli/catalogue/configs.hpp"
#include "driver/cli/catalogue/kinds.hpp"
#include "driver/cli/catalogue/methods.hpp"
#include "driver/cli/catalogue/metrics.hpp"
#include "driver/cli/catalogue/problems.hpp"
#include "driver/cli/catalogue/rows.hpp"
#include "driver/plan/metric_names.hpp"
#include "records/json/diagnostics.hpp"
#include "support/errors.hpp"
#include "support/nearest.hpp"

namespace kreisel {

const std::vector<std::string>& catalogue_topics() {
    static const std::vector<std::string> topics = [] {
        std::vector<std::string> all = {"problems", "methods", "projections", "formulations", "metrics"};
        all.insert(all.end(), kind_topics().begin(), kind_topics().end());
        all.emplace_back("configs");
        return all;
    }();
    return topics;
}

namespace {

void list_selected(const Engine& engine, const std::string& topic, const MethodFilter& filter, std::ostream& out) {
    if (!topic.empty() && topic != "methods") {
        throw UsageError("--family and the traits select methods, got the topic " + in_quotes(topic));
    }
    print_rows(out, "Methods", method_rows(selected(engine.methods(), filter)));
}

}  // namespace

void list_topic(const Engine& engine, const std::string& topic, const MethodFilter& filter, std::ostream& out) {
    if (filter.selects()) { return list_selected(engine, topic, filter, out); }
    const auto wanted = [&](const char* name) { return topic.empty() || topic == name; };
    if (wanted("problems")) { print_rows(out, "Problems", summaries(engine.problems())); }
    if (wanted("methods")) { print_rows(out, "Methods", method_rows(engine.methods())); }
    if (wanted("projections")) { print_rows(out, "Projections", summaries(engine.projections())); }
    if (wanted("formulations")) { print_rows(out, "Formulations", summaries(engine.formulations())); }
    if (wanted("metrics")) { print_rows(out, "Metrics", metric_rows()); }
    list_kinds(topic, out);
    if (wanted("configs")) { list_configs(out); }
}

void describe(const Engine& engine, const std::string& name, std::ostream& out) {
    const Catalogue catalogue(engine);
    if (const auto* problem = find_named(catalogue.problems, name)) { return describe_problem(engine, *problem, out); }
    if (const auto* method = find_named(catalogue.methods, name)) { return describe_method(*method, out); }
    if (const auto* projection = find_named(catalogue.projections, name)) {
        return describe_projection(*projection, out);
    }
    if (const auto* formulation = find_named(catalogue.formulations, name)) {
        fmt::print(out, "{}: {}\n", formulation->name, formulation->summary);
        print_sources(out, formulation->cites);
        return;
    }
    if (describe_metric(engine, name, out) || describe_kind(name, out)) { return; }
    auto names = metric_names(integral_names(engine));
    for (const auto& some : {names_of(catalogue.problems), names_of(catalogue.methods), names_of(catalogue.projections),
                             names_of(catalogue.formulations), names_of_kinds()}) {
        names.insert(names.end(), some.begin(), some.end());
    }
    const std::string nearest = nearest_name(name, names);
    throw UsageError(
        fmt::format("expected the name of a problem, method, projection, formulation, metric, kind, figure or table "
                    "(see kreisel list), got {}{}",
                    in_quotes(name), nearest.empty() ? "" : "; did you mean " + in_quotes(nearest) + "?"));
}

}  // namespace kreisel
