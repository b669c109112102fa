// SPDX-License-Identifier: BSD-3-Clause
#include "records/reference_store.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "kreisel_build.hpp"
#include "records/json/writer.hpp"
#include "records/provenance.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/hash.hpp"

namespace kreisel {

namespace {

constexpr std::string_view sum_member = ",\"sum\":\"";

Number read_number(const nlohmann::json& json) {
    const auto& text = json.get_ref<const std::string&>();
    return {nlohmann::json::parse(text).get<double>(), text};
}

template <std::size_t n>
std::array<Number, n> read_numbers(const nlohmann::json& json) {
    std::array<Number, n> numbers;
    for (std::size_t i = 0; i < n; ++i) { numbers[i] = read_number(json.at(i)); }
    return numbers;
}

ReportedBody read_body(const nlohmann::json& json) {
    ReportedBody body;
    body.name = json.at("name");
    body.x = read_numbers<3>(json.at("x"));
    body.v = read_numbers<3>(json.at("v"));
    body.omega = read_numbers<3>(json.at("omega"));
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            body.R[3 * row + column] = read_number(json.at("R").at(row).at(column));
        }
    }
    return body;
}

Reference reference_of(const nlohmann::json& json) {
    Reference reference;
    const auto& state = json.at("state");
    reference.state.t = read_number(state.at("t"));
    for (const auto& body : state.at("bodies")) { reference.state.bodies.push_back(read_body(body)); }
    for (const auto& multiplier : state.value("multipliers", nlohmann::json::array())) {
        reference.state.multipliers.push_back(read_number(multiplier));
    }
    for (const auto& angle : state.value("theta", nlohmann::json::array())) {
        reference.state.theta.push_back(read_number(angle));
    }
    reference.state.turns = state.value("turns", std::vector<long>());
    for (const auto& [name, error] : json.at("error").items()) { reference.error[name] = read_number(error); }
    reference.horizon = json.at("horizon");
    reference.route = json.at("route");
    return reference;
}

/// The text up to its check sum; nothing if it is wrong.
std::optional<std::string_view> checked(std::string_view text) {
    const auto end = text.rfind(sum_member);
    if (end == std::string_view::npos) { return std::nullopt; }
    const std::string sum = fmt::format("{}{}\"}}\n", sum_member, hash_text(text.substr(0, end)));
    return text.substr(end) == sum ? std::optional(text.substr(0, end)) : std::nullopt;
}

void write_if_different(const std::filesystem::path& file, const std::string& text) {
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error) && read_text(file) == text) { return; }
    make_folder(file.parent_path());
    write_atomically(file, text);
}

}  // namespace

std::filesystem::path reference_file(const std::filesystem::path& folder, const std::string& hash) {
    return folder / "references" / (hash + ".json");
}

StoredReference stored_reference(const PlannedReference& planned, const Reference& reference,
                                 const std::string& digest) {
    ObjectWriter error;
    for (const auto& [name, number] : reference.error) { error.member(name, json_value(number, true)); }
    ObjectWriter program;
    program.member("version", json_text(build::version)).member("commit", json_text(build::commit));
    program.member("compiler", json_text(build::compiler)).member("computed", json_text(utc_now()));
    ObjectWriter object;
    object.member("of", planned.content).member("by", json_text(digest)).member("program", program.text());
    object.member("route", json_text(reference.route)).member("horizon", json_number(reference.horizon));
    const std::string text =
        object.member("error", error.text()).member("state", json_value(reference.state, true)).open_text();
    return {reference, fmt::format("{}{}{}\"}}\n", text, sum_member, hash_text(text))};
}

std::optional<StoredReference> read_reference(const std::string& text, const PlannedReference& planned,
                                              const std::string& digest) {
    const auto whole = checked(text);
    if (!whole) { return std::nullopt; }
    try {
        const auto json = nlohmann::json::parse(std::string(*whole) + "}");
        const bool same_code = digest.empty() || json.at("by") == digest;
        if (!same_code || json.at("of") != nlohmann::json::parse(planned.content)) { return std::nullopt; }
        return StoredReference{reference_of(json), text};
    } catch (const nlohmann::json::exception&) { return std::nullopt; }  // intact, but of another format
}

std::optional<StoredReference> load_reference(const std::filesystem::path& file, const PlannedReference& planned,
                                              const std::string& digest) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) { return std::nullopt; }
    try {
        return read_reference(read_text(file), planned, digest);
    } catch (const FileError&) { return std::nullopt; }
}

std::filesystem::path default_cache_folder() {
    // The program starts threads only later, and changes no environment.
    const auto variable = [](const char* name) { return std::getenv(name); };  // NOLINT(concurrency-mt-unsafe)
    if (const char* own = variable("KREISEL_CACHE")) { return own; }
    for (const auto& [name, below] : {std::pair("XDG_CACHE_HOME", "kreisel"), std::pair("HOME", ".cache/kreisel")}) {
        const char* folder = variable(name);
        // The base directory specification: a relative path is ignored.
        if (folder != nullptr && std::filesystem::path(folder).is_absolute()) {
            return std::filesystem::path(folder) / below;
        }
    }
    return {};
}

std::filesystem::path ReferenceStore::in_results(const PlannedReference& planned) const {
    return reference_file(results_, hash_text(planned.content));
}

std::filesystem::path ReferenceStore::in_cache(const PlannedReference& planned) const {
    return reference_file(cache_, hash_text(planned.content + "\n" + digest_));
}

std::optional<StoredReference> ReferenceStore::find(const PlannedReference& planned) const {
    if (auto stored = load_reference(in_results(planned), planned, digest_)) { return stored; }
    return cache_.empty() ? std::nullopt : load_reference(in_cache(planned), planned, digest_);
}

std::string ReferenceStore::keep(const PlannedReference& planned, const StoredReference& stored) const {
    write_if_different(in_results(planned), stored.text);
    if (cache_.empty()) { return ""; }
    try {
        write_if_different(in_cache(planned), stored.text);
    } catch (const FileError& error) { return error.what(); }
    return "";
}

}  // namespace kreisel
