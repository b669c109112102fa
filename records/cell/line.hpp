// SPDX-License-Identifier: BSD-3-Clause
//
// One cell as one line of JSON, with a check sum at its end: in the journal with its times, in the results without.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "records/cell/fields.hpp"
#include "records/cell/planned.hpp"
#include "records/cell/record.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

/// What there is to say of a cell that has been run or skipped. `trajectory_sum`: of the samples, empty where there are
/// none.
CellRecord record_of(const PlannedCell& planned, const Outcome& outcome, const Reference* reference,
                     const std::string& trajectory_sum = "");

/// What a result line says, the same bytes on every run of one build. Throws std::logic_error if the record holds a
/// number that is not finite.
std::string result_text(const CellRecord& record);

/// The line of results.jsonl: that with its sum. What was run is told apart, and how it ended by the cell's line of the
/// journal, which is not read but passed on.
class ResultLine {
  public:
    /// Throws std::invalid_argument if that is none.
    ResultLine(CellIdentity identity, std::string_view journal_line);
    ResultLine(const ResultLine&) = delete;
    ResultLine& operator=(const ResultLine&) = delete;

    const std::string& text() const { return text_; }
    /// Parts of the text.
    const FieldValues& values() const { return values_; }

  private:
    std::string text_;
    FieldValues values_;
};

/// The values in a line, as parts of it. Throws std::invalid_argument where it is none.
FieldValues field_values(std::string_view line);

/// Adds the members of what was run, with which a line begins.
void add_identity(CellIdentity identity, ObjectWriter& object);

/// A line of either file. Members that are unknown here are ignored and others may be missing, so that lines of older
/// and newer versions can be read. Throws std::invalid_argument on a line that is not one.
CellRecord read_record(const std::string& line);
CellRecord read_record(const JsonValue& line);

/// The line of the journal: the result line with the times, build and check sum.
std::string journal_line(const CellRecord& record, const std::string& build);

/// Whether a line, which is not read, begins as one of that cell.
bool is_line_of(std::string_view line, const std::string& hash);

/// A journal line and the build that wrote it; nothing if it is torn or damaged, or its cell's name is none.
struct JournalledCell {
    CellRecord record;
    std::string build;
};
std::optional<JournalledCell> read_journal_line(const std::string& line);

/// What a journal line holds, or nothing if it is torn, damaged, or was written by another build.
std::optional<CellRecord> read_journal_line(const std::string& line, const std::string& build);

/// The hash of the cell that an intact journal line is about, whichever build wrote it; nothing if it is torn or
/// damaged.
std::optional<std::string> journalled_cell(const std::string& line);

}  // namespace kreisel
