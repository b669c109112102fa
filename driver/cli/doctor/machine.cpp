// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/doctor/machine.hpp"

#include <fmt/format.h>
#include <langinfo.h>
#include <locale.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "driver/campaign/workers/limits.hpp"
#include "driver/plan/estimate/amounts.hpp"
#include "kreisel_build.hpp"
#include "records/provenance.hpp"

namespace kreisel {

namespace fs = std::filesystem;

namespace {

constexpr double little_space = 1e9, little_memory = 1e9;  // bytes
constexpr rlim_t few_files = 64, few_processes = 64;

bool processor_has_v3() {
#if defined(__x86_64__)
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
#else
    return false;
#endif
}

Finding instructions() {
    const std::string_view flags = build::flags;
    const bool native = flags.find("-march=native") != std::string_view::npos,
               v3 = flags.find("-march=x86-64-v3") != std::string_view::npos;
    const bool slow = !native && !v3 && processor_has_v3();
    return {"instructions", slow ? Health::poor : Health::well,
            fmt::format("program {}, processor {} ({})",
                        native ? "native"
                        : v3   ? "x86-64-v3"
                               : "generic",
                        processor_has_v3() ? "x86-64-v3" : "generic", cpu_model()),
            slow ? "configure with -D KREISEL_ARCH=auto: steps are faster" : ""};
}

// The folder itself, or the nearest above it that there is.
fs::path existing(fs::path folder) {
    std::error_code error;
    folder = fs::absolute(folder, error);
    while (!fs::exists(folder, error) && folder.has_relative_path()) { folder = folder.parent_path(); }
    return folder;
}

// Empty, or why no file can be made in it.
std::string refusal_to_write(const fs::path& folder) {
    std::string file = (folder / ".kreisel_doctor_XXXXXX").string();
    const int descriptor = ::mkstemp(file.data());
    if (descriptor < 0) { return std::strerror(errno); }
    ::close(descriptor);
    ::unlink(file.c_str());
    return "";
}

Finding folder_of_results(const fs::path& results) {
    const fs::path folder = existing(results);
    const std::string refusal = refusal_to_write(folder);
    if (!refusal.empty()) {
        return {"results", Health::failed, fmt::format("{}: {}", folder.string(), refusal),
                "choose another folder with -o, of `kreisel run` too"};
    }
    std::error_code error;
    const auto free = static_cast<double>(fs::space(folder, error).available);
    const bool little = error || free < little_space;
    return {"results", little ? Health::poor : Health::well,
            fmt::format("{}: writable, {} free", folder.string(), size_text(error ? 0 : free)),
            little ? "make space: `kreisel check CONFIG` says what a run takes" : ""};
}

const char* written_locale() {
    for (const char* name : {"LC_ALL", "LC_NUMERIC", "LANG"}) {
        const char* value = std::getenv(name);
        if (value != nullptr && *value != '\0') { return value; }
    }
    return "C";
}

Finding numbers_of_locale() {
    const std::string name = written_locale();
    const locale_t chosen = ::newlocale(LC_ALL_MASK, "", nullptr);
    if (chosen == nullptr) {
        return {"locale", Health::poor, name + ", which is not installed", "export LC_ALL=C.UTF-8"};
    }
    const std::string point = ::nl_langinfo_l(RADIXCHAR, chosen);
    ::freelocale(chosen);
    return {"locale", Health::well,
            fmt::format("{}, decimals after \"{}\" (kreisel writes and reads \".\" whatever it is)", name, point), ""};
}

Finding limit(const std::string& topic, int resource, rlim_t few, const std::string& option) {
    rlimit found{};
    if (::getrlimit(static_cast<__rlimit_resource_t>(resource), &found) != 0) {
        return {topic, Health::poor, std::strerror(errno), ""};
    }
    const bool any = found.rlim_cur == RLIM_INFINITY, low = !any && found.rlim_cur < few;
    return {topic, low ? Health::poor : Health::well, any ? "any number" : fmt::format("{}", found.rlim_cur),
            low ? fmt::format("ulimit {} {}, or fewer workers (`kreisel run -j N`)", option, few) : ""};
}

Finding memory() {
    const auto bytes = static_cast<double>(allowed_memory());
    const bool little = bytes < little_memory;
    return {"memory", little ? Health::poor : Health::well,
            fmt::format("{} (of the machine, or as its cgroup allows)", size_text(bytes)),
            little ? "fewer workers (`kreisel run -j N`), or `--max-memory`" : ""};
}

}  // namespace

std::vector<Finding> look_at_machine(const fs::path& results) {
    return {instructions(),
            folder_of_results(results),
            numbers_of_locale(),
            limit("open files", RLIMIT_NOFILE, few_files, "-n"),
            limit("processes", RLIMIT_NPROC, few_processes, "-u"),
            memory()};
}

}  // namespace kreisel
