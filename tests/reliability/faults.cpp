// SPDX-License-Identifier: BSD-3-Clause
//
// Loaded before the C library (LD_PRELOAD), it lets one of the calls fail that write into a folder, and all later ones
// if asked to: those that open, write, cut or rename files, or make folders. All processes of a run count together.
//
//   KREISEL_FAULT_FOLDER   the folder
//   KREISEL_FAULT_AT       which call fails, counted from 1; 0: none
//   KREISEL_FAULT_ERROR    errno of the failure
//   KREISEL_FAULT_LASTS    1: all later calls fail too
//   KREISEL_FAULT_COUNTER  a file of eight bytes, in which calls are counted
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

using Counter = std::atomic<long>;
static_assert(sizeof(Counter) == 8 && Counter::is_always_lock_free);

template <class Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

const char* setting(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "" : value;
}

// Shared by the process that loads this library and all that it forks.
Counter* shared_counter() {
    static Counter* const counter = []() -> Counter* {
        const int file = next<int (*)(const char*, int, ...)>("open")(setting("KREISEL_FAULT_COUNTER"), O_RDWR);
        void* memory = ::mmap(nullptr, sizeof(Counter), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        ::close(file);
        return memory == MAP_FAILED ? nullptr : static_cast<Counter*>(memory);
    }();
    return counter;
}

bool is_ours(const std::string& path) {
    const std::string folder = setting("KREISEL_FAULT_FOLDER");
    return !folder.empty() && path.compare(0, folder.size(), folder) == 0;
}

bool is_ours(int descriptor) {
    char path[4096] = {};
    const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
    return ::readlink(link.c_str(), path, sizeof path - 1) > 0 && is_ours(std::string(path));
}

template <class Place>
bool fails(const Place& place) {
    const int before = errno;
    Counter* const counter = is_ours(place) ? shared_counter() : nullptr;
    const long at = std::atol(setting("KREISEL_FAULT_AT")), call = counter == nullptr ? 0 : ++*counter;
    const bool lasts = std::strcmp(setting("KREISEL_FAULT_LASTS"), "1") == 0;
    const bool failed = at > 0 && (call == at || (lasts && call > at));
    errno = failed ? std::atoi(setting("KREISEL_FAULT_ERROR")) : before;
    return failed;
}

int open_as(const char* name, const char* path, int flags, mode_t mode) {
    const bool writes = (flags & O_ACCMODE) != O_RDONLY;
    return writes && fails(std::string(path)) ? -1 : next<int (*)(const char*, int, ...)>(name)(path, flags, mode);
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    va_list more;
    va_start(more, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
    va_end(more);
    return open_as("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    va_list more;
    va_start(more, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
    va_end(more);
    return open_as("open64", path, flags, mode);
}

ssize_t write(int descriptor, const void* bytes, size_t size) {
    if (fails(descriptor)) { return -1; }
    return next<ssize_t (*)(int, const void*, size_t)>("write")(descriptor, bytes, size);
}

ssize_t writev(int descriptor, const iovec* parts, int count) {
    if (fails(descriptor)) { return -1; }
    return next<ssize_t (*)(int, const iovec*, int)>("writev")(descriptor, parts, count);
}

int ftruncate(int descriptor, off_t size) noexcept {
    return fails(descriptor) ? -1 : next<int (*)(int, off_t)>("ftruncate")(descriptor, size);
}

int rename(const char* from, const char* to) noexcept {
    return fails(std::string(to)) ? -1 : next<int (*)(const char*, const char*)>("rename")(from, to);
}

int mkdir(const char* path, mode_t mode) noexcept {
    return fails(std::string(path)) ? -1 : next<int (*)(const char*, mode_t)>("mkdir")(path, mode);
}
}
