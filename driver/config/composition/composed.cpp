// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/composition/composed.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "driver/config/composition/begin_file.hpp"
#include "driver/config/composition/mechanism_files.hpp"
#include "plots/figures/overlay/overlay_files.hpp"
#include "records/json/node.hpp"
#include "records/json/strict.hpp"
#include "records/manifest.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

using nlohmann::json;

constexpr const char* extends_key = "extends";

// The path that a config extends, or an empty one.
std::filesystem::path extended_by(const Document& document) {
    if (!document.value.is_object() || !document.value.contains(extends_key)) { return {}; }
    Diagnostics sink(document);
    const Node root(document.value, "", sink);
    const std::string expected = "the path of a config, relative to this file's folder";
    const auto path = root.find(extends_key)->text(expected, 4096);
    if (path && path->empty()) { root.find(extends_key)->mismatch(expected); }
    sink.raise();
    const std::filesystem::path file = std::filesystem::path(document.file).parent_path() / *path;
    if (!leads_to_file(file)) {
        root.find(extends_key)->violates(Rule::file, expected, which_is_no_file(in_quotes(*path), file));
    }
    sink.raise();
    return file;
}

// The manifest of a results folder stands for the config that it holds.
bool is_manifest(const json& value) {
    return value.is_object() && value.contains("program") && value.contains("config") && value["config"].is_object();
}

Document document_in(const std::filesystem::path& file) {
    Document document = read_document(file);
    return is_manifest(document.value) ? read_manifest(file).config : document;
}

// What a file is known by, however it is written. What is no file, such as the pipe of `kreisel check <(...)`, is known
// by its name.
std::filesystem::path identity_of(const std::filesystem::path& file) {
    std::error_code error;
    const auto path = std::filesystem::weakly_canonical(file, error);
    return error ? file : path;
}

// A file and those it extends, the last first. Throws UsageError where they extend each other in a circle.
std::vector<Document> chain_from(const std::filesystem::path& file) {
    std::vector<Document> chain = {document_in(file)};
    std::vector<std::filesystem::path> seen = {identity_of(file)};
    for (std::filesystem::path next = extended_by(chain.back()); !next.empty(); next = extended_by(chain.back())) {
        const auto path = identity_of(next);
        if (std::find(seen.begin(), seen.end(), path) != seen.end()) {
            Diagnostics sink(chain.back());
            sink.add({.pointer = std::string("/") + extends_key,
                      .expected = "a config that does not lead back to itself",
                      .got = in_quotes(next.string()),
                      .rule = Rule::file});
            sink.raise();
        }
        seen.push_back(path);
        chain.push_back(document_in(next.lexically_normal()));
    }
    std::reverse(chain.begin(), chain.end());
    return chain;
}

[[noreturn]] void refuse_setting(const std::string& setting, const std::string& reason) {
    throw UsageError(fmt::format("--set {}: {}", in_quotes(setting), reason));
}

json value_of_setting(const std::string& setting, const std::string& written) {
    if (!json::accept(written)) { return written; }
    return parse_document("--set " + setting, written).value;
}

void check_index(const json& list, const std::string& setting, const std::string& token) {
    const bool index = !token.empty() && token.size() < 8 && (token.size() == 1 || token[0] != '0') &&
                       token.find_first_not_of("0123456789") == std::string::npos;
    if (token != "-" && (!index || std::stoul(token) >= list.size())) {
        refuse_setting(setting, fmt::format("expected an index below {} or -, got {}", list.size(), in_quotes(token)));
    }
}

// Refuses a pointer into a text or number, or beyond a list. Keys that are not there are made: the reader knows which
// are valid.
void check_way(const json& whole, const std::string& setting, json::json_pointer pointer) {
    std::vector<std::string> tokens;
    for (; !pointer.empty(); pointer.pop_back()) { tokens.push_back(pointer.back()); }
    const json* place = &whole;
    for (auto token = tokens.rbegin(); token != tokens.rend(); ++token) {
        if (place->is_array()) { check_index(*place, setting, *token); }
        if (!place->is_structured()) {
            refuse_setting(setting, fmt::format("expected a list or an object above {}", in_quotes(*token)));
        }
        const bool there = place->is_array() ? *token != "-" : place->contains(*token);
        if (!there) { return; }
        place = place->is_array() ? &place->at(std::stoul(*token)) : &place->at(*token);
    }
}

json::json_pointer pointer_of(const std::string& setting, const std::string& written) {
    try {
        json::json_pointer pointer(written);
        if (!pointer.empty()) { return pointer; }
    } catch (const json::exception&) {
        // Said below, in our words.
    }
    refuse_setting(setting, "expected /POINTER=VALUE, such as /time/end=2");
}

void apply(const std::string& setting, Document& document) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) { refuse_setting(setting, "expected /POINTER=VALUE, such as /time/end=2"); }
    const json::json_pointer pointer = pointer_of(setting, setting.substr(0, equals));
    check_way(document.value, setting, pointer);
    json value = value_of_setting(setting, setting.substr(equals + 1));
    std::string place = pointer.to_string();
    if (pointer.back() == "-") {
        place = (pointer.parent_pointer() / document.value.at(pointer.parent_pointer()).size()).to_string();
    }
    document.value[pointer] = value;
    const std::string text = value.dump();
    document.layers.push_back({place, std::make_shared<const Document>(Document{"--set " + setting, text, value})});
}

Document merged_config(const std::filesystem::path& file, const std::vector<std::string>& settings) {
    std::vector<Document> chain = chain_from(file);
    if (chain.size() == 1 && settings.empty()) { return chain.front(); }
    Document whole{chain.back().file, "", chain.front().value};
    for (Document& document : chain) {
        if (!document.value.is_object()) { return document; }
        json patch = document.value;
        patch.erase(extends_key);
        if (&document != &chain.front()) { whole.value.merge_patch(patch); }
        whole.layers.push_back({"", std::make_shared<const Document>(std::move(document))});
    }
    for (const std::string& setting : settings) { apply(setting, whole); }
    whole.text = whole.value.dump(2);
    return whole;
}

}  // namespace

Document composed_config(const std::filesystem::path& file, const std::vector<std::string>& settings) {
    Document config = merged_config(file, settings);
    insert_mechanism_files(config);
    insert_begin_file(config);
    insert_overlay_files(config, "/figure");
    return config;
}

}  // namespace kreisel
