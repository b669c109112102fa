// SPDX-License-Identifier: BSD-3-Clause
#include "driver/campaign/workers/limits.hpp"

#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

namespace kreisel {

namespace {

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

// A cgroup without limit says "max".
std::uint64_t limit_in(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::uint64_t bytes = 0;
    return stream >> bytes ? bytes : no_limit;
}

// The least limit of a group and of those that it lies in.
std::uint64_t limit_of_groups(const std::filesystem::path& root, std::filesystem::path group, const char* name) {
    std::uint64_t least = limit_in(root / name);
    for (group = group.relative_path(); !group.empty(); group = group.parent_path()) {
        least = std::min(least, limit_in(root / group / name));
    }
    return least;
}

std::uint64_t limit_of_cgroups() {
    std::ifstream groups("/proc/self/cgroup");
    std::uint64_t least = no_limit;
    for (std::string line; std::getline(groups, line);) {  // "0::/path" of version 2, "4:memory:/path" of version 1
        const auto first = line.find(':'), second = line.find(':', first + 1);
        if (second == std::string::npos) { continue; }
        const std::string controllers = line.substr(first + 1, second - first - 1), group = line.substr(second + 1);
        if (controllers.empty()) {
            least = std::min(least, limit_of_groups("/sys/fs/cgroup", group, "memory.max"));
        } else if (controllers == "memory") {
            least = std::min(least, limit_of_groups("/sys/fs/cgroup/memory", group, "memory.limit_in_bytes"));
        }
    }
    return least;
}

// What RLIMIT_DATA counts, and the stack.
std::uint64_t data_bytes() {
    std::ifstream pages("/proc/self/statm");
    std::uint64_t size = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
    pages >> size >> resident >> shared >> text >> library >> data;
    return data * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

void set_timer(double seconds) {
    const double whole = std::floor(seconds);
    itimerval timer{};
    timer.it_value.tv_sec = static_cast<time_t>(whole);
    timer.it_value.tv_usec = static_cast<suseconds_t>((seconds - whole) * 1e6);
    if (seconds > 0 && timer.it_value.tv_sec == 0) {  // zero would switch it off
        timer.it_value.tv_usec = std::max<suseconds_t>(timer.it_value.tv_usec, 1);
    }
    ::setitimer(ITIMER_PROF, &timer, nullptr);
}

}  // namespace

std::uint64_t allowed_memory() {
    const auto machine =
        static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
    return std::min(machine, limit_of_cgroups());
}

void limit_memory(std::uint64_t bytes) {
    rlimit limit{};
    if (::getrlimit(RLIMIT_DATA, &limit) != 0) { return; }
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, data_bytes() + bytes);
    ::setrlimit(RLIMIT_DATA, &limit);
}

CpuLimit::CpuLimit(double seconds) : set_(seconds > 0) {
    if (set_) { set_timer(seconds); }
}

CpuLimit::~CpuLimit() {
    if (set_) { set_timer(0); }
}

}  // namespace kreisel
