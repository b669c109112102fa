// SPDX-License-Identifier: BSD-3-Clause
//
// Files that are complete or absent, and that notice a full disk. All functions throw FileError with the path and
// reason. Names of folders, named pipes and devices are refused by all that reads (support/paths/at_path.hpp).
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kreisel {

/// A file descriptor that closes itself.
class Descriptor {
  public:
    explicit Descriptor(int number = -1) : number_(number) {}
    ~Descriptor();
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    int number() const { return number_; }
    bool valid() const { return number_ >= 0; }
    /// Closes; true unless the system reports an error (a full disk may show only here).
    bool close();

  private:
    int number_;
};

void make_folder(const std::filesystem::path& folder);

std::string read_text(const std::filesystem::path& file);
std::vector<std::string> read_lines(const std::filesystem::path& file);

/// Calls `visit` with the bytes of a file, piece after piece.
void for_each_piece(const std::filesystem::path& file, const std::function<void(std::string_view piece)>& visit);

/// What happens to a last line without an end.
enum class TornLine { left_out, visited };

/// Calls `visit` with each line, and the byte at which it begins, one at a time. False if the last one has no end.
bool for_each_line(const std::filesystem::path& file,
                   const std::function<void(std::uint64_t begin, const std::string& line)>& visit,
                   TornLine torn = TornLine::left_out);

/// Writes to a temporary file beside `file` and renames it, so that a reader never sees half a file.
void write_atomically(const std::filesystem::path& file, std::string_view text);

/// The same piece by piece. The file is in its place once it is kept; one that is not leaves nothing.
class AtomicFile {
  public:
    explicit AtomicFile(std::filesystem::path file);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    void add(std::string_view text);
    void keep();

  private:
    [[noreturn]] void give_up(int error);
    void flush();

    const std::filesystem::path file_, temporary_;
    Descriptor descriptor_;
    std::string pending_;
};

/// Reads lines of a file, which may grow meanwhile, at known places.
class LineFile {
  public:
    explicit LineFile(std::filesystem::path file);
    /// The line of `size` bytes that begins at a byte, without its end.
    std::string line(std::uint64_t begin, std::size_t size) const;

  private:
    std::filesystem::path file_;
    Descriptor descriptor_;
};

/// Appends whole lines; nothing else may write to the file meanwhile. A line that could not be written completely is
/// removed again if the system allows it.
class LineAppender {
  public:
    /// What happens to existing lines.
    enum class Start { after_them, empty };
    explicit LineAppender(std::filesystem::path file, Start start = Start::after_them);
    /// The byte at which the line begins.
    std::uint64_t append(const std::string& line);

  private:
    std::filesystem::path file_;
    Descriptor descriptor_;
    std::uint64_t end_ = 0;  // of the file
};

/// Keeps other runs out of an output folder for as long as it lives (flock: a killed run leaves no stale lock).
class FolderLock {
  public:
    /// `shard` "": the whole folder. Several shards with different names may share a folder.
    FolderLock(const std::filesystem::path& folder, const std::string& shard);
    /// Of one who reads only: several may, while nobody writes. Where the lock file can only be read it is locked so;
    /// where there is none, and none can be made, nobody writes.
    static FolderLock of_reader(const std::filesystem::path& folder);

  private:
    FolderLock() = default;
    void acquire(Descriptor& descriptor, bool shared, const std::filesystem::path& folder) const;
    Descriptor folder_lock_, shard_lock_;
};

/// Keeps other processes, on this folder as well, from making the same thing at the same time: one byte of a file is
/// locked. Whoever is killed leaves nothing behind, and the file stays, for removing it would part those who wait.
class ThingLock {
  public:
    /// Waits for it until a signal arrives.
    ThingLock(const std::filesystem::path& file, const std::string& thing);
    /// False if a signal came first.
    bool held() const { return held_; }

  private:
    Descriptor file_;
    bool held_ = false;
};

}  // namespace kreisel
