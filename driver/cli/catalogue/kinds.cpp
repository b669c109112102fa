// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/catalogue/kinds.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include "driver/cli/catalogue/rows.hpp"
#include "driver/config/catalogue.hpp"
#include "plots/figures/kind.hpp"
#include "plots/tables/table.hpp"
#include "records/kinds/kind.hpp"

namespace kreisel {

namespace {

void describe_experiment(const ExperimentKind& kind, std::ostream& out) {
    fmt::print(out, "{}, a kind of experiments: {}\n", kind.name, kind.summary);
    fmt::print(out, "Metrics: {} by default{}\n", kind.metrics.empty() ? "none" : listed(kind.metrics),
               kind.timed      ? "; cells are timed, run one at a time, and measure nothing else"
               : kind.repeated ? "; cells run one at a time, and again for the CPU time of their steps"
                               : "");
    fmt::print(out, "Figure: {} by default\n", in_quotes(kind.figure));
}

const char* need_of(const FigureKind& kind) {
    switch (kind.draws) {
        case FigureData::final_states:
            return "cells";
        case FigureData::samples:
            return "samples, which the experiment must store";
        case FigureData::timed_cells:
            return "timed cells";
    }
    return "";
}

void describe_figure(const FigureKind& kind, std::ostream& out) {
    fmt::print(out, "{}, a kind of figures: {}\nDraws {}\n", kind.name, kind.summary, need_of(kind));
    const auto standard = kind.make();
    std::vector<NamedText> rows;
    for (const auto& keys : {common_figure_keys(), kind.keys}) {
        for (const FigureKey& key : keys) {
            const auto value = key.value(*standard);
            const std::string absent = value.is_null() ? key.absent : value.dump();
            rows.emplace_back(key.name, fmt::format("{}: {}{}", key.meaning, key.values,
                                                    absent.empty() ? "" : " (default " + absent + ")"));
        }
    }
    print_rows(out, "Keys", rows);
    if (!kind.metrics.empty()) { fmt::print(out, "Metrics: {}\n", listed(kind.metrics)); }
}

}  // namespace

const std::vector<std::string>& kind_topics() {
    static const std::vector<std::string> topics = {"kinds", "figures", "tables"};
    return topics;
}

void list_kinds(const std::string& topic, std::ostream& out) {
    const auto wanted = [&](const char* name) { return topic.empty() || topic == name; };
    if (wanted("kinds")) { print_rows(out, "Kinds of experiments", summaries(experiment_kinds())); }
    if (wanted("figures")) { print_rows(out, "Kinds of figures", summaries(figure_kinds())); }
    if (wanted("tables")) { print_rows(out, "Tables", summaries(result_tables())); }
}

std::vector<std::string> names_of_kinds() {
    std::vector<std::string> names = names_of(experiment_kinds());
    for (const auto& some : {names_of(figure_kinds()), names_of(result_tables())}) {
        names.insert(names.end(), some.begin(), some.end());
    }
    return names;
}

bool describe_kind(const std::string& name, std::ostream& out) {
    const ExperimentKind* experiment = find_experiment_kind(name);
    const FigureKind* figure = find_figure_kind(name);
    const ResultTable* table = find_named(result_tables(), name);
    if (experiment != nullptr) { describe_experiment(*experiment, out); }
    if (figure != nullptr) { describe_figure(*figure, out); }
    if (table != nullptr) { fmt::print(out, "{}, a table: {}\n", table->name, table->summary); }
    return experiment != nullptr || figure != nullptr || table != nullptr;
}

}  // namespace kreisel
