// SPDX-License-Identifier: BSD-3-Clause
#include "support/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "support/errors.hpp"
#include "support/hash.hpp"

namespace kreisel {

namespace {

constexpr int file_mode = 0666;  // the umask decides

[[noreturn]] void fail(const std::filesystem::path& path, const char* action, int error) {
    throw FileError(fmt::format("{}: {}: {}", path.string(), action, std::strerror(error)));
}

[[noreturn]] void fail_to_lock(const std::filesystem::path& path, int error) {
    const bool knows_none = error == ENOLCK || error == ENOSYS || error == EOPNOTSUPP;
    if (!knows_none) { fail(path, "cannot be locked", error); }
    fail(path,
         "this file system has no locks, which keep two runs apart: choose a folder on another one, or let it be "
         "mounted with locks (NFS: without nolock and local_lock; Lustre: with flock)",
         error);
}

// Returns 0, or errno of the write that failed.
int write_all(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0 && errno == EINTR) { continue; }
        if (written < 0) { return errno; }
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

int open_file(const std::filesystem::path& file, int flags) {
    return ::open(file.c_str(), flags | O_CLOEXEC, file_mode);
}

}  // namespace

Descriptor::~Descriptor() { close(); }

bool Descriptor::close() {
    const int number = number_;
    number_ = -1;
    return number < 0 || ::close(number) == 0;
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) { fail(folder, "cannot make this folder", error.value()); }
}

std::string read_text(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (!stream || (stream.peek() != std::ifstream::traits_type::eof() && !(text << stream.rdbuf())) || stream.bad()) {
        fail(file, "cannot be read", errno);
    }
    return text.str();
}

std::vector<std::string> read_lines(const std::filesystem::path& file) {
    std::vector<std::string> lines;
    std::istringstream stream(read_text(file));
    for (std::string line; std::getline(stream, line);) { lines.push_back(std::move(line)); }
    return lines;
}

void write_atomically(const std::filesystem::path& file, std::string_view text) {
    // Several programs may write the same file in a shared folder.
    const std::filesystem::path temporary = fmt::format("{}.{}.part", file.string(), ::getpid());
    Descriptor descriptor(open_file(temporary, O_WRONLY | O_CREAT | O_TRUNC));
    if (!descriptor.valid()) { fail(temporary, "cannot be opened", errno); }
    int error = write_all(descriptor.number(), text);
    if (!descriptor.close() && error == 0) { error = errno; }
    if (error == 0 && std::rename(temporary.c_str(), file.c_str()) != 0) { error = errno; }
    if (error != 0) {
        ::unlink(temporary.c_str());
        fail(file, "cannot be written", error);
    }
}

LineAppender::LineAppender(std::filesystem::path file, Start start)
    : file_(std::move(file)),
      descriptor_(open_file(file_, O_WRONLY | O_CREAT | O_APPEND | (start == Start::empty ? O_TRUNC : 0))) {
    if (!descriptor_.valid()) { fail(file_, "cannot be opened", errno); }
}

void LineAppender::append(const std::string& line) {
    const off_t end = ::lseek(descriptor_.number(), 0, SEEK_END);
    const int error = write_all(descriptor_.number(), line + "\n");
    if (error == 0) { return; }
    if (end >= 0 && ::ftruncate(descriptor_.number(), end) != 0) {
        fail(file_, "cannot be written, and its last line may be torn (a resumed run ignores it)", error);
    }
    fail(file_, "cannot be written", error);
}

FolderLock::FolderLock(const std::filesystem::path& folder, const std::string& shard)
    : folder_lock_(open_file(folder / ".lock", O_RDWR | O_CREAT)),
      shard_lock_(shard.empty() ? -1 : open_file(folder / (".lock." + shard), O_RDWR | O_CREAT)) {
    acquire(folder_lock_, !shard.empty(), folder);
    if (!shard.empty()) { acquire(shard_lock_, false, folder); }
}

void FolderLock::acquire(Descriptor& descriptor, bool shared, const std::filesystem::path& folder) const {
    if (!descriptor.valid()) { fail(folder, "cannot make a lock file in this folder", errno); }
    if (::flock(descriptor.number(), (shared ? LOCK_SH : LOCK_EX) | LOCK_NB) == 0) { return; }
    if (errno == EWOULDBLOCK) {
        throw FileError(fmt::format("{}: another run is writing to this folder", folder.string()));
    }
    fail_to_lock(folder, errno);
}

ThingLock::ThingLock(const std::filesystem::path& file, const std::string& thing)
    : file_(open_file(file, O_RDWR | O_CREAT)) {
    if (!file_.valid()) { fail(file, "cannot be opened", errno); }
    struct flock region = {};
    region.l_type = F_WRLCK;
    region.l_whence = SEEK_SET;
    region.l_start = static_cast<off_t>(hash64(thing) >> 2U);  // two things that share a byte wait in vain, no more
    region.l_len = 1;
    held_ = ::fcntl(file_.number(), F_OFD_SETLKW, &region) == 0;
    if (!held_ && errno != EINTR) { fail_to_lock(file, errno); }
}

}  // namespace kreisel
