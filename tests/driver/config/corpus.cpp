// SPDX-License-Identifier: BSD-3-Clause
//
// Every config that comes with kreisel, changed at every place: what the reader refuses for its shape the JSON Schema
// refuses, and nothing else. What else is refused breaks a rule of meaning, which has a name.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <random>
#include <set>

#include "driver/config/composition/begin_file.hpp"
#include "driver/config/composition/mechanism_files.hpp"
#include "driver/config/shipped.hpp"
#include "driver/plan/plan.hpp"
#include "kreisel_build.hpp"
#include "records/json/rules.hpp"
#include "records/json/strict.hpp"
#include "tests/driver/command_line.hpp"
#include "tests/driver/config/schema_checker.hpp"

using namespace kreisel;
using nlohmann::json;

namespace {

/// What a config comes to: refused for its shape, by rules of meaning alone, or not at all.
struct Judgement {
    bool shape = false;
    std::set<Rule> rules;
    std::string text;
};

// As a file beside the shipped mechanisms, one of which names the file of a robot.
Judgement judged(const json& config, const Engines& engines) {
    const auto file = std::filesystem::path(build::source_dir) / "experiments/mechanisms/mutant.json";
    Document document = parse_document(file.string(), config.dump());
    try {
        insert_mechanism_files(document);
        insert_begin_file(document);
        plan_of(document, engines);
    } catch (const Refusal& refusal) {
        Judgement judgement{false, {}, refusal.what()};
        for (const Issue& issue : refusal.issues) {
            judgement.shape = judgement.shape || issue.rule == Rule::shape;
            judgement.rules.insert(issue.rule);
        }
        return judgement;
    }
    return {};
}

const std::vector<json>& other_values() {
    static const std::vector<json> values = {nullptr,
                                             true,
                                             -1,
                                             2.5,
                                             2.0,
                                             5'000'000'000,
                                             0,
                                             3,
                                             "",
                                             "rkmk/rk4",
                                             "a\tb",
                                             "=1",
                                             json::array(),
                                             json::object(),
                                             json::array({1, 2, 3}),
                                             1e300,
                                             5e-324};
    return values;
}

void collect_places(const json& value, const json::json_pointer& at, std::vector<json::json_pointer>& places) {
    places.push_back(at);
    if (value.is_object()) {
        for (const auto& [key, member] : value.items()) { collect_places(member, at / key, places); }
    } else if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i) { collect_places(value[i], at / i, places); }
    }
}

// Without the value at `place`, with its key misspelt, with an entry twice or a key too many, or with another value.
std::vector<json> mutants_at(const json& config, const json::json_pointer& place) {
    std::vector<json> mutants;
    for (const json& value : other_values()) {
        mutants.push_back(config);
        mutants.back()[place] = value;
    }
    const auto change = [&](const auto& changed) {
        mutants.push_back(config);
        changed(mutants.back()[place.parent_pointer()]);
    };
    if (config.at(place.parent_pointer()).is_object()) {
        change([&](json& parent) { parent.erase(place.back()); });
        change([&](json& parent) {
            parent[place.back() + "x"] = parent[place.back()];
            parent.erase(place.back());
        });
        change([&](json& parent) { parent["extra"] = 1; });
    } else {
        change([&](json& parent) { parent.erase(std::stoul(place.back())); });
        change([&](json& parent) { parent.push_back(parent[std::stoul(place.back())]); });
    }
    return mutants;
}

std::vector<json> corpus(std::size_t count) {
    std::vector<json> all;
    for (const auto& [name, file] : configs_below(std::filesystem::path(build::source_dir) / "experiments")) {
        const json config = json::parse(contents(file));
        std::vector<json::json_pointer> places;
        collect_places(config, json::json_pointer(), places);
        for (std::size_t i = 1; i < places.size(); ++i) {
            for (json& mutant : mutants_at(config, places[i])) { all.push_back(std::move(mutant)); }
        }
    }
    std::mt19937 random(20261127);
    std::shuffle(all.begin(), all.end(), random);
    all.resize(std::min(count, all.size()));
    return all;
}

// A schema without a word, wherever it stands as one.
json without(const std::string& word, const json& schema) {
    if (!schema.is_structured()) { return schema; }
    json result = schema;
    if (result.is_object()) { result.erase(word); }
    for (json& part : result) { part = without(word, json(part)); }
    return result;
}

}  // namespace

TEST_CASE("schema and reader agree on every shipped config and its mutants", "[corpus]") {
    const Engines engines{engine_binary64(), engine_binary64()};
    SchemaChecker schema{Catalogue(engine_binary64())};
    std::size_t good = 0, shape = 0, meaning = 0, apart = 0;
    for (const json& config : corpus(5000)) {
        const Judgement judgement = judged(config, engines);
        ++(judgement.shape ? shape : judgement.rules.empty() ? good : meaning);
        const bool agree = schema.accepts(config) != judgement.shape;
        apart += agree ? 0 : 1;
        INFO(config.dump() << "\n" << judgement.text);
        CHECK(agree);
    }
    WARN(fmt::format("{} good, {} of a wrong shape, {} against a rule of meaning, {} judged differently", good, shape,
                     meaning, apart));
    CHECK(good > 100);
    CHECK(shape > 2000);
    CHECK(meaning > 100);
}

TEST_CASE("a schema that lacks one of its words is told from the reader", "[corpus]") {
    const Engines engines{engine_binary64(), engine_binary64()};
    const json whole = json::parse(config_schema(Catalogue(engine_binary64())).dump());
    const std::vector<json> mutants = corpus(1000);
    for (const std::string word : {"minimum", "required", "additionalProperties", "enum", "uniqueItems", "minItems"}) {
        SchemaChecker schema(without(word, whole));
        const bool seen = std::any_of(mutants.begin(), mutants.end(), [&](const json& config) {
            return schema.accepts(config) == judged(config, engines).shape;
        });
        INFO(word);
        CHECK(seen);
    }
}

TEST_CASE("what is no JSON, or ambiguous, is refused before its shape is looked at", "[corpus]") {
    std::size_t refused = 0;
    for (const auto& [name, file] : configs_below(std::filesystem::path(build::source_dir) / "experiments")) {
        const std::string text = json::parse(contents(file)).dump();
        const std::string kind = R"("kind":)";
        REQUIRE(text.find(kind) != std::string::npos);
        for (const std::string wrong :
             {R"("kind":"drift","kind":)", R"("time2":1e999,"kind":)", R"("x":NaN,"kind":)"}) {
            std::string changed = text;
            changed.replace(text.find(kind), kind.size(), wrong);
            CHECK_THROWS_AS(parse_document("mutant.json", changed), UsageError);
            ++refused;
        }
    }
    CHECK(refused > 150);
}

TEST_CASE("the guide lists the rules of meaning, each with its sentence", "[corpus]") {
    const std::string guide = contents(std::filesystem::path(build::source_dir) / "docs/how-to/check-configs.md");
    std::string table;
    for (const RuleDescription& rule : rules_of_meaning()) {
        table += fmt::format("| `{}` | {} |\n", rule.name, rule.sentence);
    }
    CHECK(guide.find("|---|---|\n" + table + "\n") != std::string::npos);
}
