// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/reading/problems.hpp"

#include <fmt/format.h>

#include <string_view>
#include <unordered_map>

#include "driver/config/parameters.hpp"
#include "driver/config/reading/entries.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

std::string read_label(const Node& entry, const std::string& standard) {
    const auto node = entry.is_object() ? entry.find("label") : std::nullopt;
    const auto label = node ? node->text("a label") : std::nullopt;
    // Spreadsheets read a cell with such a first character as a formula.
    if (label && std::string_view("=+-@").find(label->front()) != std::string_view::npos) {
        node->mismatch("a label that does not begin with '=', '+', '-' or '@'");
    }
    return label.value_or(standard);
}

// Fills the problems of a config, each once.
class ProblemList {
  public:
    explicit ProblemList(Config& config) : config_(config) {}

    void add(const Node& entry, ProblemEntry problem) {
        const auto [twin, is_new] = labels_.emplace(problem.label, problem.pointer);
        if (!is_new) {
            entry.violates(Rule::own_name, "a \"label\" of its own for each problem",
                           in_quotes(problem.label) + " again, as at " + twin->second);
            return;
        }
        const auto [same, is_other] =
            contents_.emplace(problem.name + " " + json_value(problem.parameters), problem.pointer);
        if (!is_other) {
            entry.violates(Rule::each_once, "each problem once", "the same problem as at " + same->second);
            return;
        }
        config_.problems.push_back(std::move(problem));
    }

  private:
    Config& config_;
    std::unordered_map<std::string, std::string> labels_, contents_;  // the pointer of each
};

void add_problems(const Node& entry, const ProblemDescription& description, ProblemList& list) {
    const std::string series = read_label(entry, description.name);
    std::vector<ParameterPoint> points = {{default_parameters(description), ""}};
    if (entry.is_object()) { entry.only_keys({"name", "label", "parameters", "exact"}); }
    const auto exact = entry.is_object() ? entry.find("exact") : std::nullopt;
    const auto parameters = entry.is_object() ? entry.find("parameters") : std::nullopt;
    const std::vector<std::string> required = required_parameters(description);
    if (parameters) {
        points = read_parameters(*parameters, description, PrintedNumbers(exact && exact->flag().value_or(false)));
    } else if (!required.empty()) {
        entry.error(fmt::format("the parameters of {}, at least {} (see kreisel info {})", in_quotes(description.name),
                                listed(required), description.name),
                    "none");
        return;
    }
    for (ParameterPoint& point : points) {
        list.add(entry, {description.name, series, series + point.listed, std::move(point.values), entry.pointer()});
    }
}

}  // namespace

void read_problems(const Node& root, const Catalogue& catalogue, Config& config) {
    const auto node = root.require("problems", "a list of at least one problem");
    if (!node) { return; }
    ProblemList list(config);
    for (const Node& entry : node->distinct_elements("a list of at least one problem", "problem")) {
        if (const auto* description = described(entry, "problem", catalogue.problems)) {
            add_problems(entry, *description, list);
        }
    }
}

}  // namespace kreisel
