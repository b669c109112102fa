// SPDX-License-Identifier: BSD-3-Clause
#include "records/manifest.hpp"

#include <fmt/format.h>

#include <thread>

#include "kreisel_build.hpp"
#include "records/json/strict.hpp"
#include "records/json/writer.hpp"
#include "records/provenance.hpp"
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
    return ObjectWriter()
        .member("version", json_text(build::version))
        .member("commit", json_text(build::commit))
        .member("build", json_text(build))
        .member("compiler", json_text(build::compiler))
        .member("flags", json_text(build::flags))
        .member("build_type", json_text(build::build_type))
        .member("libraries", libraries.text())
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
        .member("threads", fmt::format("{}", std::thread::hardware_concurrency()))
        .text();
}

}  // namespace

std::filesystem::path manifest_file(const std::filesystem::path& folder, const std::string& shard) {
    return folder / (shard.empty() ? "manifest.json" : "manifest." + shard + ".json");
}

void write_manifest(const std::filesystem::path& file, const ManifestSubject& subject, const std::string& build,
                    const ManifestTimes& times, const CellCounts& counts) {
    std::string warnings = json_value(subject.warnings);
    const std::string text = ObjectWriter()
                                 .member("format", "2")
                                 .member("name", json_text(subject.name))
                                 .member("started", json_text(times.started))
                                 .member("ended", times.ended.empty() ? "null" : json_text(times.ended))
                                 .member("cells", counts_text(counts))
                                 .member("program", program_text(build))
                                 .member("machine", machine_text())
                                 .member("warnings", warnings)
                                 .member("units", units_text(subject.units))
                                 .member("config", subject.config)
                                 .text();
    write_atomically(file, nlohmann::ordered_json::parse(text).dump(2) + "\n");
}

ManifestContents read_manifest(const std::filesystem::path& file) {
    const Document document = read_document(file);
    const auto& value = document.value;
    const bool good = value.is_object() && value.contains("config") && value.contains("program") &&
                      value["program"].is_object() && value["program"].contains("build") &&
                      value["program"]["build"].is_string();
    if (!good) { throw UsageError(fmt::format("{}: not a manifest of kreisel", file.string())); }
    return {parse_document(file.string() + " (config)", value["config"].dump(2)), value["program"]["build"]};
}

}  // namespace kreisel
