// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/composition/mechanism_files.hpp"

#include <fmt/format.h>

#include "driver/config/urdf/mechanism.hpp"
#include "records/json/node.hpp"
#include "records/json/strict.hpp"
#include "support/files.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* expected_path = "the path of a mechanism (JSON or URDF), relative to this file's folder";
constexpr const char* robot_keys[] = {"positions", "rates", "root"};

bool is_xml(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    return first != std::string::npos && text[first] == '<';
}

std::map<std::string, double> numbers_at(const Node& parameters, const char* key) {
    std::map<std::string, double> numbers;
    const auto written = parameters.find(key);
    if (!written || !written->require_object("an object: a number for each joint")) { return numbers; }
    for (const auto& entry : written->json().items()) {
        if (const auto number = written->find(entry.key())->number()) { numbers[entry.key()] = *number; }
    }
    return numbers;
}

urdf::Start read_start(const Node& parameters) {
    urdf::Start start{.positions = numbers_at(parameters, "positions"), .rates = numbers_at(parameters, "rates")};
    if (const auto root = parameters.find("root")) {
        if (const auto name = root->name("a root", {"ground", "free"})) { start.holds_root = *name == "ground"; }
    }
    return start;
}

Document robot_document(const fs::path& file, const urdf::Start& start) {
    urdf::Mechanism mechanism = urdf::read_mechanism(file, start);
    std::string text = mechanism.parameters.dump(2);
    Document document{file.string() + " as JSON", std::move(text), std::move(mechanism.parameters)};
    document.remarks = std::move(mechanism.remarks);
    return document;
}

// What the file of a problem holds; `patch` is left with what changes it.
Document mechanism_in(const fs::path& file, const Node& parameters, json& patch, const Diagnostics& sink) {
    patch.erase("file");
    if (!is_xml(read_text(file))) { return read_document(file); }
    const urdf::Start start = read_start(parameters);
    sink.raise();
    for (const char* key : robot_keys) { patch.erase(key); }
    return robot_document(file, start);
}

void insert_at(Document& config, const std::string& pointer) {
    Diagnostics sink(config);
    const Node parameters(config.value[json::json_pointer(pointer)], pointer, sink);
    const Node written = *parameters.find("file");
    const auto path = written.text(expected_path, 4096);
    sink.raise();
    const fs::path file = (folder_of(config, pointer + "/file") / *path).lexically_normal();
    if (path->empty() || !leads_to_file(file)) {
        written.violates(Rule::file, expected_path, which_is_no_file(in_quotes(*path), file));
        sink.raise();
    }
    json patch = parameters.json();
    Document mechanism = mechanism_in(file, parameters, patch, sink);
    json merged = mechanism.value;
    if (merged.is_object()) { merged.merge_patch(patch); }
    config.layers = layers_of(config);
    config.remarks.insert(config.remarks.end(), mechanism.remarks.begin(), mechanism.remarks.end());
    // Before the layers of the config, which change it.
    config.layers.insert(config.layers.begin(), {pointer, std::make_shared<const Document>(std::move(mechanism))});
    config.value[json::json_pointer(pointer)] = std::move(merged);
    config.text = config.value.dump(2);
}

bool names_file(const json& problem) {
    return problem.is_object() && problem.contains("parameters") && problem["parameters"].is_object() &&
           problem["parameters"].contains("file");
}

}  // namespace

void insert_mechanism_files(Document& config) {
    if (!config.value.is_object() || !config.value.contains("problems") || !config.value["problems"].is_array()) {
        return;
    }
    for (std::size_t i = 0; i < config.value["problems"].size(); ++i) {
        if (names_file(config.value["problems"][i])) { insert_at(config, fmt::format("/problems/{}/parameters", i)); }
    }
}

}  // namespace kreisel
