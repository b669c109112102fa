// SPDX-License-Identifier: BSD-3-Clause
#include "records/trajectory_file.hpp"

#include <fmt/format.h>

#include "records/journal.hpp"
#include "support/errors.hpp"

namespace kreisel {

namespace {

constexpr auto write_interval = std::chrono::seconds(1);
constexpr std::size_t write_at_once = 1U << 20U;  // bytes that are written without waiting

}  // namespace

std::vector<std::filesystem::path> trajectory_parts(const std::filesystem::path& folder) {
    return files_like(folder / "trajectories", "", ".csv.part");
}

std::string sum_of_trajectory(const std::filesystem::path& file) {
    std::uint64_t hash = hash64("");
    for_each_piece(file, [&](std::string_view piece) { hash = hash64(piece, hash); });
    return hash_text(hash);
}

void TrajectorySum::begin(const std::vector<Column>& columns) {
    std::string header;
    for (const Column& column : columns) {
        header += (header.empty() ? "" : ",") + fmt::format("{} [{}]", column.name, column.unit);
    }
    take(header);
}

void TrajectorySum::add(const std::string& row) {
    sampled_ = true;
    take(row);
}

void TrajectorySum::take(const std::string& line) { hash_ = hash64("\n", hash64(line, hash_)); }

void TrajectoryFile::take(const std::string& line) {
    TrajectorySum::take(line);
    pending_ += (pending_.empty() ? "" : "\n") + line;
}

void TrajectoryFile::add(const std::string& row) {
    TrajectorySum::add(row);
    if (pending_.size() > write_at_once || std::chrono::steady_clock::now() - written_ >= write_interval) { flush(); }
}

void TrajectoryFile::flush() {
    if (pending_.empty()) { return; }
    if (!stream_) { stream_ = std::make_unique<LineAppender>(part(), LineAppender::Start::empty); }
    stream_->append(pending_);
    pending_.clear();
    written_ = std::chrono::steady_clock::now();
}

void TrajectoryFile::keep() {
    flush();
    if (!stream_) { return; }
    stream_.reset();
    std::error_code error;
    std::filesystem::rename(part(), file_, error);
    if (error) { throw FileError(fmt::format("{}: cannot be written: {}", file_.string(), error.message())); }
}

void TrajectoryFile::discard() {
    stream_.reset();
    pending_.clear();
    if (file_.empty()) { return; }
    std::error_code ignored;
    std::filesystem::remove(part(), ignored);
}

}  // namespace kreisel
