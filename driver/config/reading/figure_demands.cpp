// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/reading/figure_demands.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "plots/figures/kind.hpp"
#include "records/json/diagnostics.hpp"
#include "records/kinds/kind.hpp"

namespace kreisel {

namespace {

using Names = std::vector<std::string>;

bool is_among(const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

template <class Condition>
Names figures_where(const Condition& condition) {
    Names names;
    for (const FigureKind& kind : figure_kinds()) {
        if (condition(kind)) { names.push_back(kind.name); }
    }
    return names;
}

std::vector<FigureDemand> all_demands() {
    const auto draws = [](FigureData data) { return [=](const FigureKind& kind) { return kind.draws == data; }; };
    const Names timed = figures_where(draws(FigureData::timed_cells)),
                sampled = figures_where(draws(FigureData::samples)),
                untimed = figures_where([](const auto&kind) { return kind.draws != FigureData::timed_cells; }),
                unsampled = figures_where([](const auto&kind) { return kind.draws != FigureData::samples; });
    const Names costs = {"evaluations", "exponentials", "brackets", "newton_iterations", "accepted", "rejected", "cpu"};
    return {
        {timed, {}, Provision::timed, "a figure of states or errors (this one draws experiments of that kind)"},
        {untimed, {}, Provision::not_timed, listed(timed) + ", the figure of an experiment of this kind"},
        {sampled,
         {},
         Provision::samples,
         "an experiment that stores samples (\"output\": {\"samples\": K}), since this figure draws them"},
        {sampled, costs, Provision::repeated, "a kind of experiment whose samples tell their cost (work_precision)"},
        {unsampled, {"cpu"}, Provision::repeated, "a kind of experiment that measures it"},
        {unsampled,
         {"exponentials", "brackets", "newton_iterations"},
         Provision::counted,
         "a kind of experiment that counts them, or tolerances"},
        {figures_where([](const auto&) { return true; }),
         {"tolerance", "rejected"},
         Provision::tolerances,
         "tolerances in \"time\""},
        {unsampled, {"h"}, Provision::constant_steps, "steps of one size in \"time\""},
    };
}

template <class Condition>
Names kinds_where(const Condition& condition) {
    Names names;
    for (const ExperimentKind& kind : experiment_kinds()) {
        if (condition(kind)) { names.push_back(kind.name); }
    }
    return names;
}

bool has(const nlohmann::json& config, const char* group, const char* key) {
    return config.contains(group) && config[group].is_object() && config[group].contains(key);
}

}  // namespace

bool FigureDemand::concerns(const std::string& kind, const std::string& drawn_against) const {
    return is_among(kinds, kind) && (x.empty() || is_among(x, drawn_against));
}

const std::vector<FigureDemand>& figure_demands() {
    static const std::vector<FigureDemand> demands = all_demands();
    return demands;
}

bool provides(const nlohmann::json& config, Provision what) {
    const auto is_of = [&](const Names& kinds) {
        return config.contains("kind") && config["kind"].is_string() &&
               is_among(kinds, config["kind"].get<std::string>());
    };
    switch (what) {
        case Provision::timed:
            return is_of(timed_kinds());
        case Provision::not_timed:
            return !is_of(timed_kinds());
        case Provision::samples:
            return has(config, "output", "samples") && config["output"]["samples"].is_number() &&
                   config["output"]["samples"].get<double>() >= 1;
        case Provision::repeated:
            return is_of(repeated_kinds());
        case Provision::counted:
            return provides(config, Provision::repeated) || provides(config, Provision::tolerances);
        case Provision::tolerances:
            return has(config, "time", "tolerance");
        case Provision::constant_steps:
            return has(config, "time", "steps") || has(config, "time", "step");
    }
    return false;
}

std::vector<std::string> timed_kinds() {
    return kinds_where([](const ExperimentKind& kind) { return kind.timed; });
}

std::vector<std::string> repeated_kinds() {
    return kinds_where([](const ExperimentKind& kind) { return kind.repeated; });
}

}  // namespace kreisel
