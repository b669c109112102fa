// SPDX-License-Identifier: BSD-3-Clause
#include "records/provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <gnu/libc-version.h>

#include <ctime>
#include <fstream>

#include "kreisel_build.hpp"
#include "records/loaded_libraries.hpp"
#include "support/files.hpp"
#include "support/hash.hpp"

namespace kreisel {

std::string build_id() {
    static const std::string id = [] {
        std::uint64_t hash = hash64(read_text("/proc/self/exe"));
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
