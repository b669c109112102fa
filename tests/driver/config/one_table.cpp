// SPDX-License-Identifier: BSD-3-Clause
//
// What a figure, an option or a parameter may be stands in one description: reader, schema and `kreisel info` say the
// same of every key of it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>
#include <sstream>

#include "driver/cli/catalogue/kinds.hpp"
#include "driver/config/config.hpp"
#include "driver/config/schema.hpp"
#include "plots/figures/kind.hpp"
#include "plots/figures/schema.hpp"
#include "plots/figures/spec.hpp"
#include "records/json/strict.hpp"
#include "records/json/writer.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/config/schema_checker.hpp"

using namespace kreisel;
using nlohmann::json;

namespace one_table {

namespace {

std::vector<FigureKey> keys_of(const FigureKind& kind) {
    std::vector<FigureKey> keys = common_figure_keys();
    keys.insert(keys.end(), kind.keys.begin(), kind.keys.end());
    return keys;
}

std::set<std::string> members_of(const json& object) {
    std::set<std::string> names;
    for (const auto& [name, value] : object.items()) { names.insert(name); }
    return names;
}

// The errors of one figure that a schema can tell.
std::vector<Issue> shape_errors(const json& figure) {
    const Document document = parse_document("f.json", figure.dump());
    Diagnostics diagnostics(document);
    read_figures(Node(document.value, "", diagnostics), "e");
    try {
        diagnostics.raise();
    } catch (const Refusal& refusal) {
        std::vector<Issue> issues = refusal.issues;
        std::erase_if(issues, [](const Issue& issue) { return issue.rule != Rule::shape; });
        return issues;
    }
    return {};
}

// All objects of a schema whose `name` can only be this.
void find_called(const std::string& name, const json& schema, std::vector<const json*>& found) {
    if (schema.is_object() && schema.value(json::json_pointer("/properties/name/const"), "") == name) {
        found.push_back(&schema.at("properties"));
    }
    if (!schema.is_structured()) { return; }
    for (const json& part : schema) { find_called(name, part, found); }
}

const json& only_called(const std::string& name, const json& schema) {
    std::vector<const json*> found;
    find_called(name, schema, found);
    REQUIRE(found.size() == 1);
    return *found.front();
}

// Whether the good config with this change is refused at this place.
bool is_wrong(const json& patch, const std::string& pointer, Target target) {
    json config = json::parse(good_config());
    config.merge_patch(patch);
    try {
        read_config(parse_document("c.json", config.dump()), Catalogue(plain_engine));
    } catch (const Refusal& refusal) {
        return std::any_of(refusal.issues.begin(), refusal.issues.end(),
                           [&](const Issue& issue) { return issue.pointer == pointer && issue.target == target; });
    }
    return false;
}

const std::vector<json>& values_of_all_kinds() {
    static const std::vector<json> values = {
        true, -1, 2, 0.5, "method", "a\tb", "", json::array(), {1, 2, 3}, json{{2, 1}}, json{{"a", "b"}}};
    return values;
}

}  // namespace

TEST_CASE("schema and reader know the keys of the table of figures, and judge values of each alike", "[one_table]") {
    const json schema = json::parse(figure_schema().dump());
    REQUIRE(schema.at("anyOf").size() == figure_kinds().size());
    SchemaChecker checker(schema);
    int refused = 0;
    for (const json& shape : schema.at("anyOf")) {
        const FigureKind* kind = find_figure_kind(shape.at("properties").at("kind").at("const"));
        REQUIRE(kind != nullptr);
        std::set<std::string> known = {"kind"};
        for (const FigureKey& key : keys_of(*kind)) {
            known.insert(key.name);
            for (const json& value : values_of_all_kinds()) {
                const json figure = {{"kind", kind->name}, {key.name, value}};
                const bool good = shape_errors(figure).empty();
                INFO(figure.dump());
                CHECK(checker.accepts(figure) == good);
                refused += good ? 0 : 1;
            }
            const std::vector<Issue> unknown = shape_errors({{"kind", kind->name}, {key.name + "x", 1}});
            REQUIRE(unknown.size() == 1);
            CHECK(unknown.front().target == Target::key);
        }
        CHECK(members_of(shape.at("properties")) == known);
    }
    CHECK(refused > 1000);
}

TEST_CASE("info tells all keys of the table of figures, what they mean and may be", "[one_table]") {
    for (const FigureKind& kind : figure_kinds()) {
        std::ostringstream out;
        REQUIRE(describe_kind(kind.name, out));
        std::string words;  // whatever the width of lines
        std::istringstream in(out.str());
        for (std::string word; in >> word;) { words += word + " "; }
        for (const FigureKey& key : keys_of(kind)) {
            INFO(kind.name << " " << key.name << "\n" << words);
            CHECK(words.find(" " + key.name + " " + key.meaning + ": " + key.values) != std::string::npos);
        }
    }
}

TEST_CASE("the schema has the options of methods and projections as they describe them", "[one_table]") {
    const json schema = json::parse(config_schema(Catalogue(plain_engine)).dump());
    const auto check = [&](const std::string& list, const std::string& name,
                           const std::vector<OptionDescription>& options) {
        INFO(name);
        const json& properties = only_called(name, schema);
        std::set<std::string> known = {"name"};
        for (const OptionDescription& option : options) {
            INFO(option.name);
            known.insert(option.name);
            const json& shape = properties.at(option.name);
            CHECK(shape.at("description") == option.summary);
            const json standard = json::parse(json_value(option.standard));
            CHECK(shape.value("default", json("")) == standard);
            const json with = {{"name", name}, {option.name, standard == "" ? json(7.5) : standard}};
            CHECK(is_wrong({{list, {with}}}, "/" + list + "/0/" + option.name, Target::value) == (standard == ""));
            const json unknown = {{"name", name}, {option.name + "x", 1}};
            CHECK(is_wrong({{list, {unknown}}}, "/" + list + "/0/" + option.name + "x", Target::key));
        }
        CHECK(members_of(properties) == known);
    };
    for (const MethodDescription& method : plain_engine.methods()) { check("methods", method.name, method.options); }
    for (const ProjectionDescription& projection : plain_engine.projections()) {
        check("projections", projection.name, projection.options);
    }
}

TEST_CASE("the schema has the parameters of problems as they describe them", "[one_table]") {
    const json schema = json::parse(config_schema(Catalogue(plain_engine)).dump());
    for (const ProblemDescription& problem : plain_engine.problems()) {
        const json& properties = only_called(problem.name, schema).at("parameters").at("properties");
        std::set<std::string> known = {"file", "positions", "rates", "root"};
        for (const ParameterDescription& parameter : problem.parameters) {
            INFO(problem.name << " " << parameter.name);
            known.insert(parameter.name);
            const json& shape = properties.at(parameter.name);
            CHECK(shape.at("description") == parameter.summary + " [" + parameter.unit + "]");
            CHECK(shape.contains("default") == !parameter.required);
            if (!parameter.required) { CHECK(shape.at("default") == json::parse(json_value(parameter.standard))); }
        }
        CHECK(members_of(properties) == known);
    }
}

}  // namespace one_table
