// SPDX-License-Identifier: BSD-3-Clause
#include "records/manifest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <thread>

#include "kreisel_build.hpp"
#include "records/journal.hpp"
#include "records/json/lists.hpp"
#include "records/json/strict.hpp"
#include "records/json/writer.hpp"
#include "records/loaded_libraries.hpp"
#include "records/provenance.hpp"
#include "records/sums/sum_list.hpp"
#include "records/sums/summed_text.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

std::string counts_text(const CellCounts& counts) {
    ObjectWriter object;
    object.member("total", fmt::format("{}", counts.total)).member("ok", fmt::format("{}", counts.ok));
    object.member("skipped", fmt::format("{}", counts.skipped)).member("failed", fmt::format("{}", counts.failed));
    return object.member("missing", fmt::format("{}", counts.missing)).text();
}

std::string program_text(const std::string& build) {
    ObjectWriter libraries;
    for (const auto& [name, version] : library_versions()) { libraries.member(name, json_text(version)); }
    ObjectWriter loaded;
    for (const auto& [name, id] : numerical_libraries()) { loaded.member(name, json_text(id)); }
    return ObjectWriter()
        .member("version", json_text(build::version))
        .member("commit", json_text(build::commit))
        .member("build", json_text(build))
        .member("compiler", json_text(build::compiler))
        .member("flags", json_text(build::flags))
        .member("build_type", json_text(build::build_type))
        .member("libraries", libraries.text())
        .member("loaded", loaded.text())
        .text();
}

std::string units_text(const Units& units) {
    ObjectWriter object;
    for (const auto& [metric, unit] : units) { object.member(metric, json_text(unit)); }
    return object.text();
}

std::string machine_text() {
    return ObjectWriter()
        .member("cpu", json_text(cpu_model()))
        .member("instructions", json_text(instruction_level()))
        .member("threads", fmt::format("{}", std::thread::hardware_concurrency()))
        .text();
}

std::string journal_text(const ManifestState& state) {
    return ObjectWriter().member("bytes", fmt::format("{}", *state.journal)).text();
}

/// When and by what: the members that a manifest says of its run and later ones keep.
constexpr std::array run_members = {"started", "ended", "cells", "program", "machine"};

std::string run_of(const nlohmann::json& manifest) {
    nlohmann::ordered_json run;
    for (const char* member : run_members) {
        if (manifest.contains(member)) { run[member] = manifest[member]; }
    }
    return run.dump();
}

std::vector<std::string> earlier_runs(const nlohmann::json& manifest) {
    std::vector<std::string> runs;
    const auto earlier = manifest.find("earlier");
    if (earlier == manifest.end() || !earlier->is_array()) { return runs; }
    for (const auto& run : *earlier) { runs.push_back(run.dump()); }
    return runs;
}

std::vector<std::string> listed_files(const nlohmann::json& manifest) {
    std::vector<std::string> files;
    const auto listed = manifest.find("files");
    if (listed == manifest.end() || !listed->is_array()) { return files; }
    for (const auto& file : *listed) {
        if (file.is_string() && is_path_below(file.get<std::string>())) { files.push_back(file); }
    }
    return files;
}

std::size_t count_of(const nlohmann::json& manifest, const char* name) {
    const auto pointer = nlohmann::json::json_pointer(std::string("/cells/") + name);
    return manifest.contains(pointer) && manifest[pointer].is_number_unsigned() ? manifest[pointer].get<std::size_t>()
                                                                                : 0;
}

std::string text_of(const nlohmann::json& manifest, const char* name) {
    return manifest.contains(name) && manifest[name].is_string() ? manifest[name].get<std::string>() : "";
}

ManifestState state_of(const nlohmann::json& manifest) {
    ManifestState state;
    state.build = manifest["program"]["build"];
    state.started = text_of(manifest, "started");
    state.ended = text_of(manifest, "ended");
    state.counts.total = count_of(manifest, "total");
    state.counts.missing = count_of(manifest, "missing");
    const auto bytes = nlohmann::json::json_pointer("/journal/bytes");
    if (manifest.contains(bytes) && manifest[bytes].is_number_unsigned()) { state.journal = manifest[bytes]; }
    state.files = listed_files(manifest);
    state.earlier = earlier_runs(manifest);
    state.plan = text_of(manifest, "plan");
    return state;
}

// Unreleased versions have written 2 without sums and without a list of files.
int format_said(const nlohmann::json& manifest) {
    const auto format = manifest.is_object() ? manifest.find("format") : manifest.end();
    const bool told = format != manifest.end() && format->is_number_integer() && manifest.contains("files");
    return told ? format->get<int>() : 1;
}

}  // namespace

std::filesystem::path manifest_file(const std::filesystem::path& folder, const std::string& shard) {
    return folder / (shard.empty() ? "manifest.json" : "manifest." + shard + ".json");
}

void write_manifest(const std::filesystem::path& file, const ManifestSubject& subject, const ManifestState& state) {
    ObjectWriter object;
    object.member("format", fmt::format("{}", folder_format)).member("name", json_text(subject.name));
    object.member("started", json_text(state.started));
    object.member("ended", state.ended.empty() ? "null" : json_text(state.ended));
    object.member("cells", counts_text(state.counts)).member("program", program_text(state.build));
    object.member("machine", machine_text());
    if (!state.plan.empty()) { object.member("plan", json_text(state.plan)); }
    if (!state.earlier.empty()) { object.member("earlier", json_list(state.earlier, std::identity())); }
    if (state.journal) { object.member("journal", journal_text(state)); }
    object.member("warnings", json_value(subject.warnings)).member("units", units_text(subject.units));
    object.member("config", subject.config).member("files", json_value(state.files));
    std::string text = nlohmann::ordered_json::parse(object.text()).dump(2);
    text.resize(text.size() - std::string_view("\n}").size());
    write_atomically(file, with_sum(text, indented_sum));
}

Document read_summed_manifest(const std::filesystem::path& file) {
    const std::string text = read_text(file);
    const SumState sum = sum_state(text, indented_sum);
    if (sum == SumState::wrong) { throw FileError(fmt::format("{}: damaged: its sum does not hold", file.string())); }
    try {
        Document document = parse_document(file.string(), text);
        if (sum == SumState::absent && format_said(document.value) >= folder_format) {
            throw FileError(fmt::format("{}: damaged: it has no sum", file.string()));
        }
        return document;
    } catch (const UsageError& error) {
        // What a parser says of a config says nothing of a file that is cut or overwritten, but where.
        const std::string told = error.what(), place = told.substr(0, told.find(": ", file.string().size()));
        throw FileError(fmt::format("{}: damaged: expected the JSON that a run has written", place));
    }
}

ManifestContents read_manifest(const std::filesystem::path& file) {
    const Document document = read_summed_manifest(file);
    const auto& value = document.value;
    const bool good = value.is_object() && value.contains("config") && value.contains("program") &&
                      value["program"].is_object() && value["program"].contains("build") &&
                      value["program"]["build"].is_string();
    if (!good) { throw UsageError(fmt::format("{}: not a manifest of kreisel", file.string())); }
    return {parse_document(file.string() + " (config)", value["config"].dump(2)), state_of(value), format_said(value),
            run_of(value)};
}

int format_of(const std::filesystem::path& folder) {
    int format = 1;
    for (const auto& file : shard_files(folder, "manifest", ".json")) {
        try {
            format = std::max(format, format_said(read_summed_manifest(file).value));
        } catch (const FileError&) { continue; }  // damaged: it does not tell
    }
    return format;
}

}  // namespace kreisel
