// SPDX-License-Identifier: BSD-3-Clause
#include "records/reference_store.hpp"

#include <cstdlib>
#include <stdexcept>

#include "kreisel_build.hpp"
#include "records/cell/codec.hpp"
#include "records/journal.hpp"
#include "records/json/lists.hpp"
#include "records/json/writer.hpp"
#include "records/provenance.hpp"
#include "records/sums/summed_text.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/hash.hpp"

namespace kreisel {

namespace {

using ErrorBounds = std::map<std::string, Number>;

std::string bounds_text(const ErrorBounds& error) {
    ObjectWriter object;
    for (const auto& [name, number] : error) { object.member(name, json_value(number, true)); }
    return object.text();
}

ErrorBounds bounds_of(const JsonValue& json) {
    ErrorBounds error;
    for (const JsonMember& bound : json.members) { decode(bound.value, error[bound.name]); }
    return error;
}

std::string sample_text(const ReferenceSample& sample) {
    return ObjectWriter()
        .member("error", bounds_text(sample.error))
        .member("state", json_value(sample.state, true))
        .text();
}

Reference reference_of(const JsonValue& json) {
    Reference reference;
    decode(json.at("state"), reference.state);
    reference.error = bounds_of(json.at("error"));
    reference.horizon = json.at("horizon").number();
    reference.route = json.at("route").string();
    const JsonValue* samples = json.find("samples");
    if (samples == nullptr) { return reference; }
    for (const JsonValue& entry : samples->elements) {
        ReferenceSample& sample = reference.samples.emplace_back();
        decode(entry.at("state"), sample.state);
        sample.error = bounds_of(entry.at("error"));
    }
    return reference;
}

constexpr const char* lock_name = ".lock.references";

/// A reference's file is one line.
constexpr SumStyle sum_of_reference{compact_sum.before, "\"}\n"};

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
    ObjectWriter program;
    program.member("version", json_text(build::version)).member("commit", json_text(build::commit));
    program.member("compiler", json_text(build::compiler)).member("computed", json_text(utc_now()));
    ObjectWriter object;
    object.member("of", planned.content).member("by", json_text(digest)).member("program", program.text());
    object.member("route", json_text(reference.route)).member("horizon", json_number(reference.horizon));
    object.member("error", bounds_text(reference.error)).member("state", json_value(reference.state, true));
    if (!reference.samples.empty()) { object.member("samples", json_list(reference.samples, sample_text)); }
    return {.reference = reference, .text = with_sum(object.open_text(), sum_of_reference)};
}

std::optional<StoredReference> read_reference(const std::string& text, const PlannedReference& planned,
                                              const std::string& digest) {
    if (!is_whole_reference(text)) { return std::nullopt; }
    try {
        const JsonValue json = parse_exactly(std::string(before_sum(text, sum_of_reference)) + "}");
        const bool same_code = json.at("by").string().starts_with(digest);
        if (!same_code || json.at("of") != parse_exactly(planned.content)) { return std::nullopt; }
        return StoredReference{.reference = reference_of(json), .text = text};
    } catch (const std::invalid_argument&) { return std::nullopt; }  // intact, but of another format
}

std::optional<StoredReference> load_reference(const std::filesystem::path& file, const PlannedReference& planned,
                                              const std::string& digest) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) { return std::nullopt; }
    try {
        return read_reference(read_text(file), planned, digest);
    } catch (const FileError&) { return std::nullopt; }
}

std::string digest_of_sources(const std::string& digest) { return digest.substr(0, digest.find('-')); }

std::optional<StoredReference> given_reference(const std::filesystem::path& folder, const PlannedReference& planned,
                                               const std::string& digest) {
    if (folder.empty()) { return std::nullopt; }
    auto stored =
        load_reference(reference_file(folder, hash_text(planned.content)), planned, digest_of_sources(digest));
    if (stored) { stored->given = true; }
    return stored;
}

bool is_whole_reference(const std::string& text) { return sum_state(text, sum_of_reference) == SumState::holds; }

std::vector<std::string> reference_damage(const std::filesystem::path& folder) {
    std::vector<std::string> damage;
    for (const auto& file : files_like(folder / "references", "", ".json")) {
        try {
            if (is_whole_reference(read_text(file))) { continue; }
            damage.push_back(file.string() + ":1: damaged: its sum does not hold");
        } catch (const FileError& error) { damage.emplace_back(error.what()); }
    }
    return damage;
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
    if (auto stored = given_reference(given_, planned, digest_)) { return stored; }
    return cache_.empty() ? std::nullopt : load_reference(in_cache(planned), planned, digest_);
}

bool ReferenceStore::is_damaged(const PlannedReference& planned) const {
    std::error_code error;
    const auto file = in_results(planned);
    return std::filesystem::is_regular_file(file, error) && !is_whole_reference(read_text(file));
}

ThingLock ReferenceStore::lock(const PlannedReference& planned) const {
    if (!cache_.empty()) {
        try {
            make_folder(cache_);
            return ThingLock(cache_ / lock_name, planned.content + "\n" + digest_);
        } catch (const FileError&) {}  // keep says so, and the cache is not used
    }
    return ThingLock(results_ / lock_name, planned.content);
}

std::string ReferenceStore::keep(const PlannedReference& planned, const StoredReference& stored) const {
    write_if_different(in_results(planned), stored.text);
    if (cache_.empty() || stored.given) { return ""; }
    try {
        write_if_different(in_cache(planned), stored.text);
    } catch (const FileError& error) { return error.what(); }
    return "";
}

}  // namespace kreisel
