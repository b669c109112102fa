// SPDX-License-Identifier: BSD-3-Clause
//
// What a worker is asked to do, and what it answers. Internal to the campaign.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "driver/campaign/finished.hpp"

namespace kreisel {

/// A reference solution, a batch of cells, or a further round of a cell's CPU time.
struct Job {
    enum class Kind : char { reference = 'r', cells = 'c', round = 't' };
    Kind kind = Kind::cells;
    std::string reference;           ///< its hash
    std::vector<std::size_t> cells;  ///< by index
    bool alone = false;              ///< while no other worker is at work, with all memory

    std::string text() const;
    static Job read(const std::string& text);
};

/// A worker answers a batch cell by cell. Answers are the letter and a text.
enum class Answered : char {
    record = 'c',        ///< how the cell ended, and its line of the journal (record_text)
    no_memory = 'm',     ///< memory was refused; the text: what else there is to say
    part = 'p',          ///< the cell was interrupted and has left samples: a line of the journal
    interrupted = 'i',   ///< the same without samples, or a reference
    seconds = 't',       ///< of a round; empty: none
    reference = 'r',     ///< it was computed and is in the results; the text: why it is not in the cache
    found = 'k',         ///< the same of one that was known
    no_reference = 'x',  ///< what was thrown
    file_error = 'f',    ///< a file could not be read or written, which ends the run
};

std::string answer_text(Answered kind, std::string_view text = "");

/// What a worker says of a cell that has ended: apart from the line, which is passed on unread, how.
std::string record_text(const CellEnding& ending, std::string_view line);
/// The same read; a text that is none says that the cell is missing.
CellEnding ending_in(std::string_view text);
std::string_view line_in(std::string_view text);

}  // namespace kreisel
