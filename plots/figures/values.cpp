// SPDX-License-Identifier: BSD-3-Clause
#include "plots/figures/values.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "plots/figures/cells/cell_value.hpp"
#include "plots/tables/names.hpp"
#include "records/metrics/catalogue.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace figure_value {

namespace {

using Schema = nlohmann::ordered_json;

constexpr std::size_t longest_metric = 100, longest_text = 200;
constexpr double column_width = 85, full_width = 170, least_width = 30, most_width = 500;  // mm

Schema text_schema() {
    return {
        {"type", "string"}, {"minLength", 1}, {"maxLength", longest_text}, {"pattern", "^[^\\u0000-\\u001F\\u007F]*$"}};
}

Schema positive_schema() { return {{"type", "number"}, {"minimum", least_positive}, {"maximum", largest_number}}; }

Schema between_schema(double least, double most) { return {{"type", "number"}, {"minimum", least}, {"maximum", most}}; }

std::optional<double> read_between(const Node& node, double least, double most, const std::string& expected) {
    const auto number = node.number(expected);
    if (!number || (*number >= least && *number <= most)) { return number; }
    node.mismatch(expected);
    return std::nullopt;
}

Schema one_or_many(const Schema& one) {
    return {{"anyOf", {one, {{"type", "array"}, {"items", one}, {"minItems", 1}}}}};
}

std::function<Schema()> fixed(const Schema& schema) {
    return [=] { return schema; };
}

// The value itself, or the elements of a list that is not empty.
std::vector<Node> read_one_or_many(const Node& node, const std::string& expected) {
    if (!node.is_array()) { return {node}; }
    return node.elements(expected).value_or(std::vector<Node>());
}

/// Which metrics a figure draws.
struct MetricChoice {
    Names families, own;

    /// Those that are known before there is a problem: all but first integrals.
    Names known() const {
        Names names = own;
        for (const std::string& name : names_of_metrics()) {
            const auto begins = [&](const std::string& family) { return name.starts_with(family); };
            if (std::any_of(families.begin(), families.end(), begins)) { names.push_back(name); }
        }
        return names;
    }
    bool integrals() const { return std::find(families.begin(), families.end(), "invariant.") != families.end(); }
};

bool is_integral_name(const std::string& metric) {
    const std::string prefix = "invariant.";
    return metric.starts_with(prefix) && metric.size() > prefix.size() &&
           metric.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_.") == std::string::npos;
}

std::optional<std::string> read_metric(const Node& node, const MetricChoice& choice, const std::string& expected) {
    const auto metric = node.text(expected, longest_metric);
    if (!metric) { return std::nullopt; }
    const Names known = choice.known();
    const bool fits = std::find(known.begin(), known.end(), *metric) != known.end() ||
                      (choice.integrals() && is_integral_name(*metric));
    if (fits) { return metric; }
    node.mismatch(expected, nearest_name(*metric, known));
    return std::nullopt;
}

Schema metric_schema(const MetricChoice& choice) {
    Schema one = {{"type", "string"}, {"maxLength", longest_metric}};
    one["anyOf"] = Schema::array({{{"enum", choice.known()}}});
    if (choice.integrals()) { one["anyOf"].push_back({{"pattern", "^invariant\\.[a-z0-9_.]+$"}}); }
    Schema several = one_or_many(one);
    several["anyOf"][1]["uniqueItems"] = true;
    return several;
}

const Names& precisions() {
    static const Names names = {"double", "quad"};
    return names;
}

std::optional<std::string> read_selected(const Node& node, const std::string& key) {
    if (key == "tolerance") {
        const auto tolerance = node.positive("a tolerance, or a list of them");
        return tolerance ? std::optional(fmt::format("{}", *tolerance)) : std::nullopt;
    }
    if (key == "precision") { return node.name("a precision", precisions()); }
    if (key != "steps") { return node.text("a name, or a list of names"); }
    const auto steps = node.count(1, largest_count, "steps");
    return steps ? std::optional(fmt::format("{}", *steps)) : std::nullopt;
}

// A list as a value stands in a list of values.
std::optional<std::string> read_cell_value(const Node& node) {
    if (node.json().is_null() || node.is_object()) {
        node.mismatch("a number, a text, true, false, a list as a value in a list of values, or a list of these");
        return std::nullopt;
    }
    return cell_value_text(parse_exactly(node.json().dump()));
}

Schema cell_value_schema() {
    const Schema one = {{"type", {"number", "string", "boolean", "array"}}};
    Schema several = one_or_many(one);
    several["anyOf"][0]["type"].erase(3);  // a list is one of values
    return several;
}

Names selection_keys() {
    Names keys = CellNames::figure_axes();
    keys.insert(keys.end(), {"steps", "tolerance"});
    return keys;
}

std::optional<Selection> read_selection(const Node& node) {
    if (!node.require_object("an object such as {\"formulation\": \"SE3\"}")) { return std::nullopt; }
    Names known = selection_keys();
    Selection selection;
    for (const auto& entry : node.json().items()) {
        const std::string& key = entry.key();
        if (is_cell_value(key)) { known.push_back(key); }
        if (std::find(known.begin(), known.end(), key) == known.end()) { continue; }
        for (const Node& one : read_one_or_many(*node.find(key), "a value, or a list of at least one")) {
            const auto value = is_cell_value(key) ? read_cell_value(one) : read_selected(one, key);
            if (value) { selection[key].push_back(*value); }
        }
    }
    node.only_keys(known);
    return selection;
}

}  // namespace

Type<std::string> text(const std::string& expected) {
    return {expected, fixed(text_schema()), [=](const Node& node) { return node.text(expected, longest_text); }};
}

Type<std::string> file_name() {
    const std::string expected = "a file name without extension: up to 80 of a-z, 0-9, \"_\", \"-\"";
    return {expected, fixed({{"type", "string"}, {"pattern", "^[a-z0-9_][a-z0-9_-]{0,79}$"}}), [=](const Node& node) {
                auto name = node.text(expected);
                if (!name || is_figure_name(*name)) { return name; }
                node.mismatch(expected);
                return std::optional<std::string>();
            }};
}

Type<std::string> choice(const std::string& what, const Names& names) {
    return {"one of " + listed(names), fixed({{"type", "string"}, {"enum", names}}),
            [=](const Node& node) { return node.name(what, names); }};
}

Type<std::string> axis() { return choice("facet", CellNames::figure_axes()); }

Type<bool> flag() {
    return {"true or false", fixed({{"type", "boolean"}}), [](const Node& node) { return node.flag(); }};
}

Type<long> count(long least, long most, const std::string& what) {
    return {fmt::format("a whole number from {} to {}", least, most),
            fixed({{"type", "integer"}, {"minimum", least}, {"maximum", most}}),
            [=](const Node& node) { return node.count(least, most, what); }};
}

Type<double> positive(const std::string& expected) {
    return {expected, fixed(positive_schema()), [=](const Node& node) { return node.positive(expected); }};
}

Type<double> number(const std::string& expected) {
    return {expected, fixed(between_schema(-largest_number, largest_number)),
            [=](const Node& node) { return node.number(expected); }};
}

Type<double> between(double least, double most, const std::string& what) {
    const std::string expected = fmt::format("{} from {} to {}", what, least, most);
    return {expected, fixed(between_schema(least, most)),
            [=](const Node& node) { return read_between(node, least, most, expected); }};
}

Type<double> page_width() {
    const Schema named = {{"type", "string"}, {"enum", {"column", "page"}}};
    const std::string expected = fmt::format("\"column\" ({} mm), \"page\" ({} mm), or a width from {} to {} mm",
                                             column_width, full_width, least_width, most_width);
    return {expected, fixed({{"anyOf", {named, between_schema(least_width, most_width)}}}),
            [=](const Node& node) -> std::optional<double> {
                if (node.json() == "column") { return column_width; }
                if (node.json() == "page") { return full_width; }
                return read_between(node, least_width, most_width, expected);
            }};
}

Type<std::array<double, 2>> range() {
    auto type = numbers<2>("a list of two numbers, the smaller one first");
    const auto read_two = type.read;
    type.read = [=](const Node& node) -> std::optional<std::array<double, 2>> {
        auto two = read_two(node);
        if (two && !(two->front() < two->back())) {
            node.violates(Rule::figure_range, "a lower and a higher number",
                          fmt::format("{} and {}", two->front(), two->back()));
            return std::nullopt;
        }
        return two;
    };
    return type;
}

Type<Names> names(const std::string& expected) {
    const Schema schema = {{"type", "array"}, {"items", text_schema()}, {"minItems", 1}, {"uniqueItems", true}};
    return {"a list: each " + expected, fixed(schema), [=](const Node& node) -> std::optional<Names> {
                const auto entries = node.elements("a list of at least one entry: each " + expected);
                if (!entries) { return std::nullopt; }
                Names all;
                for (const Node& entry : distinct(*entries, "name")) {
                    if (const auto one = entry.text(expected, longest_text)) { all.push_back(*one); }
                }
                return all;
            }};
}

Type<std::map<std::string, std::string>> texts(const std::string& expected) {
    using Texts = std::map<std::string, std::string>;
    const Schema schema = {{"type", "object"}, {"additionalProperties", text_schema()}};
    return {"an object: by name, " + expected, fixed(schema), [=](const Node& node) -> std::optional<Texts> {
                if (!node.require_object("an object: by name, " + expected)) { return std::nullopt; }
                Texts all;
                for (const auto& entry : node.json().items()) {
                    if (const auto one = node.find(entry.key())->text(expected, longest_text)) {
                        all[entry.key()] = *one;
                    }
                }
                return all;
            }};
}

template <std::size_t n>
Type<std::array<double, n>> numbers(const std::string& expected) {
    const Schema one = {{"type", "number"}, {"minimum", -largest_number}, {"maximum", largest_number}};
    const Schema schema = {{"type", "array"}, {"items", one}, {"minItems", n}, {"maxItems", n}};
    return {expected, fixed(schema), [=](const Node& node) -> std::optional<std::array<double, n>> {
                if (!node.is_array() || node.json().size() != n) {
                    node.mismatch(expected);
                    return std::nullopt;
                }
                std::array<double, n> result{};
                const auto entries = node.elements_or_self();
                for (std::size_t i = 0; i < n; ++i) {
                    const auto value = entries[i].number();
                    if (!value) { return std::nullopt; }
                    result[i] = *value;
                }
                return result;
            }};
}
template Type<std::array<double, 2>> numbers(const std::string& expected);
template Type<std::array<double, 3>> numbers(const std::string& expected);

Type<Names> metrics(const Names& families, const Names& own) {
    std::string several;
    for (const std::string& family : families) { several += (several.empty() ? "" : " or ") + family + "*"; }
    const std::string words = fmt::format("a metric {}, or a list of them", several);
    const std::string expected = words + " (see kreisel list metrics)";
    const MetricChoice choice{families, own};
    return {words, [=] { return metric_schema(choice); },
            [=](const Node& node) {
                Names names;
                for (const Node& entry : distinct(read_one_or_many(node, expected), "metric")) {
                    if (const auto metric = read_metric(entry, choice, expected)) { names.push_back(*metric); }
                }
                return std::optional(names);
            }};
}

Type<Selection> selection() {
    Schema properties = Schema::object();
    for (const std::string& key : selection_keys()) { properties[key] = one_or_many(text_schema()); }
    properties["steps"] = one_or_many({{"type", "integer"}, {"minimum", 1}, {"maximum", largest_count}});
    properties["tolerance"] = one_or_many(positive_schema());
    properties["precision"] = one_or_many({{"type", "string"}, {"enum", precisions()}});
    const Schema values = {{"^(parameter|option|projection_option)[.].", cell_value_schema()}};
    return {"an object of values or lists of values: keys " + listed(selection_keys()) +
                ", and \"parameter.NAME\", \"option.NAME\", \"projection_option.NAME\"",
            fixed({{"type", "object"},
                   {"properties", properties},
                   {"patternProperties", values},
                   {"additionalProperties", false}}),
            read_selection};
}

}  // namespace figure_value

bool is_figure_name(const std::string& name) {
    const bool letters = name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_-") == std::string::npos;
    return letters && !name.empty() && name.size() <= 80 && name[0] != '-';
}

}  // namespace kreisel
