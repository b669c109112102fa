// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <unordered_set>

#include "driver/config/keys/keys.hpp"
#include "driver/config/reading/begin.hpp"

namespace kreisel {

namespace {

constexpr double whole_tolerance = 1e-9;  // how far end/step may be from a whole number, relative to it

// Fills the numbers of steps of a config, each once.
class StepList {
  public:
    explicit StepList(Config& config) : config_(config) {}

    void add(const Node& node, long steps) {
        if (known_.insert(steps).second) {
            config_.steps.push_back(steps);
        } else {
            node.violates(Rule::each_once, "each number of steps once", fmt::format("{} again", steps));
        }
    }
    const Config& config() const { return config_; }

  private:
    Config& config_;
    std::unordered_set<long> known_;
};

// The value itself, or the different ones of a list.
std::vector<Node> one_or_several(const Node& node, const std::string& what) {
    if (!node.is_array()) { return {node}; }
    const std::string bare = what.substr(what.find(' ') + 1);
    return node.distinct_elements(what + ", or a list of them", bare);
}

void read_geometric(const Node& node, StepList& list) {
    node.only_keys(names_of(step_series_keys()));
    const auto from = read_key(node, step_series_keys(), "from", step_count_kind());
    const auto levels = read_key(node, step_series_keys(), "levels", level_count_kind());
    const auto factor = read_key(node, step_series_keys(), "factor", level_factor_kind(), 2L);
    if (!from || !levels || !factor) { return; }
    long steps = *from;
    for (long level = 0; level < *levels; ++level) {
        if (level > 0 && steps > largest_count / *factor) {
            node.violates(Rule::finest_level, fmt::format("at most {} steps at the finest level", largest_count),
                          fmt::format("{} * {}^{}", *from, *factor, *levels - 1));
            return;
        }
        steps *= level > 0 ? *factor : 1;
        list.add(node, steps);
    }
}

void read_steps(const Node& node, StepList& list) {
    if (node.is_object()) {
        read_geometric(node, list);
        return;
    }
    for (const Node& entry : one_or_several(node, step_count_kind().what)) {
        if (const auto steps = read(entry, step_count_kind())) { list.add(entry, *steps); }
    }
}

void read_step_sizes(const Node& node, StepList& list) {
    for (const Node& entry : one_or_several(node, "a step in s")) {
        const auto step = read(entry, step_kind());
        const double duration = list.config().duration();
        if (!step || !(duration > 0)) { continue; }
        const double ratio = duration / *step;
        const double steps = std::round(ratio);
        if (!(ratio <= static_cast<double>(largest_count)) || steps < 1 ||
            std::abs(ratio - steps) > whole_tolerance * steps) {
            entry.violates(Rule::whole_steps,
                           fmt::format("a step that divides {} {} into 1 to {} equal steps",
                                       list.config().begin ? "the time from begin to end," : "the end time", duration,
                                       largest_count),
                           fmt::format("{}, which gives {} steps", *step, ratio));
            continue;
        }
        list.add(entry, static_cast<long>(steps));
    }
}

void add_tolerance(const Node& node, double tolerance, Config& config) {
    if (std::find(config.tolerances.begin(), config.tolerances.end(), tolerance) != config.tolerances.end()) {
        node.violates(Rule::each_once, "each tolerance once", fmt::format("{} again", tolerance));
        return;
    }
    config.tolerances.push_back(tolerance);
}

// Decimals such as 1e-07, which a quotient may miss by its rounding.
double to_15_digits(double value) { return std::strtod(fmt::format("{:.14e}", value).c_str(), nullptr); }

void read_geometric_tolerances(const Node& node, Config& config) {
    node.only_keys(names_of(tolerance_series_keys()));
    const auto from = read_key(node, tolerance_series_keys(), "from", tolerance_kind());
    const auto levels = read_key(node, tolerance_series_keys(), "levels", level_count_kind());
    const auto factor = read_key(node, tolerance_series_keys(), "factor", level_factor_kind(), 10L);
    if (!from || !levels || !factor) { return; }
    for (long level = 0; level < *levels; ++level) {
        const double divisor = std::pow(static_cast<double>(*factor), static_cast<double>(level));
        const double tolerance = level == 0 ? *from : to_15_digits(*from / divisor);
        if (!(tolerance >= least_positive)) {
            node.violates(Rule::finest_level,
                          fmt::format("a tolerance of at least {} at the finest level", least_positive),
                          fmt::format("{} / {}^{}", *from, *factor, level));
            return;
        }
        add_tolerance(node, tolerance, config);
    }
}

void read_tolerances(const Node& node, Config& config) {
    if (node.is_object()) { return read_geometric_tolerances(node, config); }
    for (const Node& entry : one_or_several(node, "a tolerance")) {
        if (const auto tolerance = read(entry, tolerance_kind())) { add_tolerance(entry, *tolerance, config); }
    }
}

void read_controller(const Node& time, Config& config) {
    const auto node = find_key(time, time_keys(), "controller");
    if (!node) { return; }
    config.controller = read(*node, controller_kind()).value_or(config.controller);
    if (!time.find("tolerance")) { node->error("\"tolerance\" beside it, to which it chooses the steps", "none"); }
}

void read_begin_into(const Node& time, const Node& begin, Config& config) {
    config.begin = read_begin(begin);
    if (!config.begin || config.t_end == 0 || config.duration() > 0) { return; }
    time.find("end")->violates(Rule::begin,
                               fmt::format("an end after the time of \"begin\", {} s", config.begin->t.value),
                               fmt::format("{}", config.t_end));
}

}  // namespace

void read_time(const Node& time, Config& config) {
    const std::string& expected = find_named(config_keys(), "time")->missing;
    if (!time.require_object(expected)) { return; }
    time.only_keys(names_of(time_keys()));
    config.t_end = read_key(time, time_keys(), "end", end_kind()).value_or(0);
    if (const auto begin = find_key(time, time_keys(), "begin")) { read_begin_into(time, *begin, config); }
    const auto steps = find_key(time, time_keys(), "steps");
    const auto step = find_key(time, time_keys(), "step");
    const auto tolerance = find_key(time, time_keys(), "tolerance");
    if (tolerance) { read_tolerances(*tolerance, config); }
    read_controller(time, config);
    StepList list(config);
    if (steps && step) {
        step->error("either \"steps\" or \"step\"", "both");
    } else if (steps) {
        read_steps(*steps, list);
    } else if (step) {
        read_step_sizes(*step, list);
    } else if (!tolerance) {
        time.error(expected, "neither \"steps\" nor \"step\" nor \"tolerance\"");
    }
}

}  // namespace kreisel
