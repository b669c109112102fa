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
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

constexpr int file_mode = 0666;                // the umask decides
constexpr std::size_t piece_size = 1U << 16U;  // bytes that are read or written together

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

std::ifstream opened(const std::filesystem::path& file) {
    require_file(file);
    std::ifstream stream(file, std::ios::binary);
    if (!stream) { fail(file, "cannot be read", errno); }
    return stream;
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
    std::ifstream stream = opened(file);
    std::ostringstream text;
    if ((stream.peek() != std::ifstream::traits_type::eof() && !(text << stream.rdbuf())) || stream.bad()) {
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

void for_each_piece(const std::filesystem::path& file, const std::function<void(std::string_view piece)>& visit) {
    std::ifstream stream = opened(file);
    std::string piece(piece_size, '\0');
    while (stream.read(piece.data(), static_cast<std::streamsize>(piece.size())) || stream.gcount() > 0) {
        visit(std::string_view(piece).substr(0, static_cast<std::size_t>(stream.gcount())));
    }
    if (stream.bad()) { fail(file, "cannot be read", errno); }
}

bool for_each_line(const std::filesystem::path& file,
                   const std::function<void(std::uint64_t begin, const std::string& line)>& visit, TornLine torn) {
    std::ifstream stream = opened(file);
    std::uint64_t begin = 0;
    for (std::string line; std::getline(stream, line); begin += line.size() + 1) {
        if (!stream.eof() || torn == TornLine::visited) { visit(begin, line); }
        if (stream.eof()) { return false; }
    }
    if (stream.bad()) { fail(file, "cannot be read", errno); }
    return true;
}

void write_atomically(const std::filesystem::path& file, std::string_view text) {
    AtomicFile whole(file);
    whole.add(text);
    whole.keep();
}

// Several programs may write the same file in a shared folder.
AtomicFile::AtomicFile(std::filesystem::path file)
    : file_(std::move(file)),
      temporary_(fmt::format("{}.{}.part", file_.string(), ::getpid())),
      descriptor_(open_file(temporary_, O_WRONLY | O_CREAT | O_TRUNC)) {
    if (!descriptor_.valid()) { fail(file_, "cannot be written", errno); }
}

AtomicFile::~AtomicFile() {
    if (descriptor_.valid()) { ::unlink(temporary_.c_str()); }
}

void AtomicFile::add(std::string_view text) {
    pending_ += text;
    if (pending_.size() >= piece_size) { flush(); }
}

void AtomicFile::flush() {
    if (const int error = write_all(descriptor_.number(), pending_); error != 0) { give_up(error); }
    pending_.clear();
}

void AtomicFile::keep() {
    flush();
    if (!descriptor_.close()) { give_up(errno); }
    if (std::rename(temporary_.c_str(), file_.c_str()) != 0) { give_up(errno); }
}

void AtomicFile::give_up(int error) {
    descriptor_.close();
    ::unlink(temporary_.c_str());
    fail(file_, "cannot be written", error);
}

LineFile::LineFile(std::filesystem::path file) : file_(std::move(file)) {
    require_file(file_);
    descriptor_ = Descriptor(open_file(file_, O_RDONLY));
    if (!descriptor_.valid()) { fail(file_, "cannot be read", errno); }
}

std::string LineFile::line(std::uint64_t begin, std::size_t size) const {
    std::string text(size, '\0');
    for (std::size_t done = 0; done < size;) {
        const ssize_t got =
            ::pread(descriptor_.number(), text.data() + done, size - done, static_cast<off_t>(begin + done));
        if (got < 0 && errno == EINTR) { continue; }
        if (got < 0) { fail(file_, "cannot be read", errno); }
        if (got == 0) { throw FileError(fmt::format("{}: has become shorter while it was read", file_.string())); }
        done += static_cast<std::size_t>(got);
    }
    return text;
}

LineAppender::LineAppender(std::filesystem::path file, Start start) : file_(std::move(file)) {
    if (what_is_no_file(file_) != "a device") { require_file(file_); }
    descriptor_ = Descriptor(open_file(file_, O_WRONLY | O_CREAT | O_APPEND | (start == Start::empty ? O_TRUNC : 0)));
    const off_t end = descriptor_.valid() ? ::lseek(descriptor_.number(), 0, SEEK_END) : -1;
    if (end < 0) { fail(file_, "cannot be opened", errno); }
    end_ = static_cast<std::uint64_t>(end);
}

std::uint64_t LineAppender::append(const std::string& line) {
    const int error = write_all(descriptor_.number(), line + "\n");
    if (error == 0) { return std::exchange(end_, end_ + line.size() + 1); }
    if (::ftruncate(descriptor_.number(), static_cast<off_t>(end_)) != 0) {
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

FolderLock FolderLock::of_reader(const std::filesystem::path& folder) {
    const auto file = folder / ".lock";
    FolderLock lock;
    lock.folder_lock_ = Descriptor(open_file(file, O_RDWR | O_CREAT));
    const bool read_only = errno == EROFS || errno == EACCES || errno == EPERM;
    if (!lock.folder_lock_.valid() && read_only) {
        lock.folder_lock_ = Descriptor(open_file(file, O_RDONLY));
        if (!lock.folder_lock_.valid() && errno == ENOENT) { return lock; }
    }
    lock.acquire(lock.folder_lock_, true, folder);
    return lock;
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
