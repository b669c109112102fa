// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/keys/keys.hpp"

#include <stdexcept>

#include "driver/config/catalogue.hpp"
#include "records/kinds/kind.hpp"

namespace kreisel {

namespace {

constexpr long most_levels = 64, largest_factor = 1000, most_samples = 10'000'000;

ConfigKeys series_keys(const std::string& from, const std::string& levels, const std::string& factor) {
    return {{"from", from, from}, {"levels", levels, levels}, {"factor", factor}};
}

}  // namespace

const ConfigKeys& config_keys() {
    static const ConfigKeys keys = {
        {"name", "name of the experiment, and of its folder",
         "a name of letters, digits, '_', '-' and '.', beginning with neither '.' nor '-'"},
        {"description", "what the experiment shows, kept in the manifest"},
        {"kind", "what is measured", "one of " + listed(names_of(experiment_kinds()))},
        {"precision", "double (the default), quad, or a list of both"},
        {"problems", "names, or objects with name, label, parameters and exact", "a list of at least one problem"},
        {"formulations", "groups on which a body lives; SO3xR3 by default"},
        {"methods", "names, a family as \"rkmk/*\", all as \"*\", or objects with name and options",
         "a list of at least one method"},
        {"projections", "names, or objects with name and options; none by default"},
        {"time", "end of the run, and its steps", "an object with \"end\" and \"steps\", \"step\" or \"tolerance\""},
        {"metrics", "names, or patterns with *; by kind where it is left out"},
        {"output", "what is stored of a run"},
        {"figure", "what kreisel plot draws: an object with a kind and its keys, or a list of them"}};
    return keys;
}

const ConfigKeys& time_keys() {
    static const ConfigKeys keys = {
        {"begin", "the sample of an earlier trajectory to go on from; the start of the problem, at 0 s, by default"},
        {"end", "end of the integration, s", "the end time, greater than 0 (s)"},
        {"steps", "number of steps, a list of numbers, or {from, levels, factor}"},
        {"step", "step size, s, in place of steps; divides the end"},
        {"tolerance", "to which steps are chosen, instead of steps of one size or beside them"},
        {"controller", "of steps to a tolerance; pi by default"}};
    return keys;
}

const ConfigKeys& begin_keys() {
    static const ConfigKeys keys = {{"t", "time of the state, s", "the time of the state (s)"},
                                    {"bodies", "states of all bodies", "a list of the states of all bodies"},
                                    {"turns", "full turns of each torsion spring, by its name in samples"}};
    return keys;
}

const ConfigKeys& begin_body_keys() {
    static const ConfigKeys keys = {{"name", "of the body", "the name of a body"},
                                    {"x", "mass centre, space axes, m", "three numbers"},
                                    {"R", "rotation, body to space", "three rows of three numbers"},
                                    {"v", "velocity of the mass centre, space axes, m/s", "three numbers"},
                                    {"omega", "angular velocity, body axes, rad/s", "three numbers"}};
    return keys;
}

const ConfigKeys& begin_file_keys() {
    static const ConfigKeys keys = {
        {"file", "path of a trajectory (results/NAME/trajectories/CELL.csv), relative to the config",
         "the path of a trajectory"},
        {"t", "time of the sample, s; the last by default"}};
    return keys;
}

const ConfigKeys& output_keys() {
    static const ConfigKeys keys = {
        {"samples", "K: K + 1 equidistant samples are kept; 0 by default, the final state only"},
        {"dense", "whether samples to a tolerance may fall between steps; true by default"}};
    return keys;
}

const ConfigKeys& step_series_keys() {
    static const ConfigKeys keys = series_keys("the smallest number of steps", "how many step counts there are",
                                               "between neighbours; 2 by default");
    return keys;
}

const ConfigKeys& tolerance_series_keys() {
    static const ConfigKeys keys =
        series_keys("the largest tolerance", "how many tolerances there are", "between neighbours; 10 by default");
    return keys;
}

const TextKind& description_kind() {
    static const TextKind kind{"a text that describes the experiment", 2000};
    return kind;
}

const NameKind& kind_of_experiment() {
    static const NameKind kind{"a kind", names_of(experiment_kinds())};
    return kind;
}

const NameKind& precision_kind() {
    static const NameKind kind{"a precision", {"double", "quad"}};
    return kind;
}

const PositiveKind& end_kind() {
    static const PositiveKind kind{"an end time greater than 0 (s)"};
    return kind;
}

const PositiveKind& step_kind() {
    static const PositiveKind kind{"a step greater than 0 (s)"};
    return kind;
}

const CountKind& step_count_kind() {
    static const CountKind kind{"a number of steps", 1, largest_count};
    return kind;
}

const PositiveKind& tolerance_kind() {
    static const PositiveKind kind{"a tolerance greater than 0 and less than 1", 1.0};
    return kind;
}

const NameKind& controller_kind() {
    static const NameKind kind{"a controller", {"elementary", "pi", "pid"}};
    return kind;
}

const CountKind& level_count_kind() {
    static const CountKind kind{"a number of levels", 1, most_levels};
    return kind;
}

const CountKind& level_factor_kind() {
    static const CountKind kind{"a factor", 2, largest_factor};
    return kind;
}

const CountKind& sample_count_kind() {
    static const CountKind kind{"a number of samples", 0, most_samples};
    return kind;
}

std::optional<Node> find_key(const Node& object, const ConfigKeys& keys, const std::string& name) {
    const ConfigKey* key = find_named(keys, name);
    if (key == nullptr) { throw std::logic_error("a key is read that no config has: " + name); }
    return key->missing.empty() ? object.find(name) : object.require(name, key->missing);
}

}  // namespace kreisel
