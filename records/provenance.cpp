// SPDX-License-Identifier: BSD-3-Clause
#include "records/provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <sys/auxv.h>

#include <ctime>
#include <fstream>

#include "kreisel_build.hpp"
#include "records/loaded_libraries.hpp"
#include "support/files.hpp"
#include "support/hash.hpp"

namespace kreisel {

namespace {

constexpr const char* own_file = "/proc/self/exe";

}  // namespace

bool has_proc() {
    std::error_code none;
    return std::filesystem::is_symlink(own_file, none);
}

std::filesystem::path program_file() {
    std::error_code none;
    const std::filesystem::path file = std::filesystem::read_symlink(own_file, none);
    if (!none) { return file; }
    const auto name = getauxval(AT_EXECFN);
    if (name == 0) { return {}; }
    return std::filesystem::absolute(reinterpret_cast<const char*>(name), none);  // NOLINT: an address, says the system
}

std::string build_id() {
    static const std::string id = [] {
        // As it was loaded, even where its file has been replaced since; without /proc the file is all there is.
        std::uint64_t hash = hash64("");
        for_each_piece(has_proc() ? own_file : program_file(),
                       [&](std::string_view piece) { hash = hash64(piece, hash); });
        for (const auto& [name, library] : numerical_libraries()) { hash = hash64(name + " " + library + "\n", hash); }
        return hash_text(hash64(instruction_level(), hash));
    }();
    return id;
}

std::vector<std::pair<std::string, std::string>> library_versions() {
    return {{"Boost", build::boost},
            {"CLI11", build::cli11},
            {"Eigen", build::eigen},
            {"GSL", build::gsl},
            {"fmt", build::fmt},
            {"glibc", gnu_get_libc_version()},
            {"nlohmann-json", build::nlohmann_json}};
}

std::string cpu_model() {
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) { return line.substr(colon + 2); }
    }
    return "";
}

std::string utc_now() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

}  // namespace kreisel
