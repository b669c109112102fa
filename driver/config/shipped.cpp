// SPDX-License-Identifier: BSD-3-Clause
#include "driver/config/shipped.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <vector>

#include "kreisel_build.hpp"
#include "records/json/diagnostics.hpp"
#include "records/provenance.hpp"
#include "support/errors.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace fs = std::filesystem;

namespace {

// Relative to the working folder where it lies below that.
fs::path brief(const fs::path& file) {
    std::error_code none;
    const fs::path relative = fs::relative(file, none);
    return none || relative.empty() || *relative.begin() == ".." ? file : relative;
}

std::string nearest_config(const std::string& name, const std::map<std::string, fs::path>& shipped) {
    std::vector<std::string> names;
    for (const auto& [known, file] : shipped) { names.push_back(known); }
    const std::string nearest = nearest_name(name, names);
    return nearest.empty() ? "" : "; did you mean " + in_quotes(nearest) + "?";
}

bool is_path(const fs::path& written) { return written.has_parent_path() || written.extension() == ".json"; }

}  // namespace

fs::path shipped_folder() {
    if (const char* chosen = std::getenv("KREISEL_EXPERIMENTS")) { return chosen; }  // NOLINT(concurrency-mt-unsafe)
    std::error_code none;
    const auto installed = program_file().parent_path().parent_path() / "share" / "kreisel" / "experiments";
    if (fs::is_directory(installed, none)) { return installed; }
    const fs::path sources = fs::path(build::source_dir) / "experiments";
    return fs::is_directory(sources, none) ? sources : fs::path();
}

std::map<std::string, fs::path> configs_below(const fs::path& folder) {
    std::map<std::string, fs::path> configs;
    std::error_code none;
    for (const auto& entry : fs::recursive_directory_iterator(folder, none)) {
        if (entry.path().extension() != ".json") { continue; }
        const auto [twin, is_new] = configs.emplace(entry.path().stem().string(), entry.path());
        if (!is_new) {
            throw UsageError(fmt::format("expected one config of each name in {}, got {} and {}", folder.string(),
                                         twin->second.string(), entry.path().string()));
        }
    }
    return configs;
}

fs::path config_file(const fs::path& written) {
    std::error_code none;
    // A folder that is called like a config does not hide it; a path to a folder is refused by the reader.
    if (fs::exists(written, none) && (is_path(written) || !fs::is_directory(written, none))) { return written; }
    const fs::path folder = shipped_folder();
    const auto shipped = configs_below(folder);
    if (is_path(written)) {
        throw FileError(fmt::format("{}: there is no such file{}", written.string(),
                                    nearest_config(written.stem().string(), shipped)));
    }
    const auto found = shipped.find(written.string());
    if (found != shipped.end()) { return brief(found->second); }
    throw UsageError(fmt::format("expected a file, or the name of a config in {}, got {}{}", folder.string(),
                                 in_quotes(written.string()), nearest_config(written.string(), shipped)));
}

}  // namespace kreisel
