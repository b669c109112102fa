// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/parts.hpp"

#include <fmt/format.h>

#include <optional>

#include "driver/plan/shards.hpp"
#include "records/journal.hpp"
#include "support/errors.hpp"

namespace kreisel {

void PlanOfParts::add(const std::filesystem::path& manifest, const std::string& digest) {
    const std::filesystem::path folder = manifest.parent_path();
    if (manifest == manifest_file(folder, "")) { return; }
    if (digest.empty()) {
        if (warning_.empty()) {
            warning_ = fmt::format(
                "{}: warning: written by an older version, without the digest of its plan: whether it fits the other "
                "parts cannot be told",
                manifest.string());
        }
        return;
    }
    if (digest_.empty()) {
        whose_ = folder.string();
        digest_ = digest;
    }
    if (digest == digest_) { return; }
    throw UsageError(
        fmt::format("{}: expected a part of the plan {} ({}), got one of the plan {} ({}): parts have the "
                    "same cells, as many parts and the same build in common",
                    folder.string(), digest_, whose_, digest, manifest.filename().string()));
}

namespace {

// Empty: it does not say. Where it is damaged, run_damage says so; the config of another version is not ours to plan.
std::optional<std::string> told_plan(const std::filesystem::path& manifest) {
    try {
        return read_manifest(manifest).state.plan;
    } catch (const FileError&) { return std::nullopt; } catch (const UsageError&) {
        return std::nullopt;
    }
}

}  // namespace

std::string check_parts(const std::filesystem::path& folder, const Plan& plan, const RunSettings& settings) {
    if (settings.shards == 1 || settings.overwrite) { return ""; }
    PlanOfParts parts(plan_digest(plan, settings.shards));
    for (const auto& file : shard_files(folder, "manifest", ".json")) {
        if (const auto digest = told_plan(file)) { parts.add(file, *digest); }
    }
    return parts.warning();
}

}  // namespace kreisel
