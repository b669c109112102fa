// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/reading/problems.hpp"

#include <fmt/format.h>

#include <string_view>
#include <unordered_map>

#include "driver/config/keys/keys.hpp"
#include "driver/config/parameters.hpp"
#include "driver/config/reading/entries.hpp"
#include "driver/config/reading/shapes.hpp"
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

// Fills the problems of a config, each once. Those of one entry differ in the values that are listed for it, each of
// which is there once.
class ProblemList {
  public:
    ProblemList(Config& config, bool several_entries) : config_(config), several_entries_(several_entries) {}

    void add(const Node& entry, ProblemSeries made) {
        const auto series = std::make_shared<const ProblemSeries>(std::move(made));
        for (std::size_t point = 0; point < series->size(); ++point) {
            ProblemPoint problem(series, point);
            if (!several_entries_ || is_new(entry, problem)) { config_.problems.push_back(std::move(problem)); }
        }
    }

  private:
    bool is_new(const Node& entry, const ProblemPoint& problem) {
        const std::string label = problem.label();
        const auto [twin, has_own_label] = labels_.emplace(label, problem.pointer());
        if (!has_own_label) {
            entry.violates(Rule::own_name, "a \"label\" of its own for each problem",
                           in_quotes(label) + " again, as at " + twin->second);
            return false;
        }
        const auto [same, is_other] =
            contents_.emplace(problem.name() + " " + problem.parameters_text(), problem.pointer());
        if (!is_other) {
            entry.violates(Rule::each_once, "each problem once", "the same problem as at " + same->second);
        }
        return is_other;
    }

    Config& config_;
    const bool several_entries_;
    std::unordered_map<std::string, std::string> labels_, contents_;  // the pointer of each
};

void add_problems(const Node& entry, const ProblemDescription& description, ProblemList& list) {
    const std::string label = read_label(entry, description.name);
    ReadParameters read{default_parameters(description)};
    Shapes shapes;
    if (entry.is_object()) { entry.only_keys({"name", "label", "parameters", "exact"}); }
    const auto exact = entry.is_object() ? entry.find("exact") : std::nullopt;
    const auto parameters = entry.is_object() ? entry.find("parameters") : std::nullopt;
    const std::vector<std::string> required = required_parameters(description);
    if (parameters) {
        read = read_parameters(*parameters, description, PrintedNumbers(exact && exact->flag().value_or(false)));
        shapes = read_shapes(*parameters, description);
    } else if (!required.empty()) {
        entry.error(fmt::format("the parameters of {}, at least {} (see kreisel info {})", in_quotes(description.name),
                                listed(required), description.name),
                    "none");
        return;
    }
    list.add(entry, ProblemSeries({description.name, label, entry.pointer(), std::move(read.values),
                                   std::move(read.axes), std::move(shapes)},
                                  std::move(read.varying)));
}

}  // namespace

void read_problems(const Node& root, const Catalogue& catalogue, Config& config) {
    const auto node = find_key(root, config_keys(), "problems");
    if (!node) { return; }
    const auto entries = node->distinct_elements("a list of at least one problem", "problem");
    ProblemList list(config, entries.size() > 1);
    for (const Node& entry : entries) {
        if (const auto* description = described(entry, "problem", catalogue.problems)) {
            add_problems(entry, *description, list);
        }
    }
}

}  // namespace kreisel
