// SPDX-License-Identifier: BSD-3-Clause
//
// What `kreisel table` writes: a file of this folder for each table, which registers itself.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "plots/tables/text.hpp"
#include "records/results.hpp"
#include "support/registration.hpp"

namespace kreisel {

/// One table as files: `full` as CSV, and as Markdown, LaTeX and on the terminal the brief one, which may be the same.
struct TablePair {
    TextTable full;
    std::optional<TextTable> abridged = {};
    const TextTable& brief() const { return abridged ? *abridged : full; }
};
/// One of them, without a copy: there may be a row for each of many cells.
std::vector<TablePair> one_table(TextTable full, std::optional<TextTable> abridged = {});

/// When a table applies, or is printed.
using OfResults = bool (*)(const Results&);
bool always(const Results& results);
bool never(const Results& results);
bool has_errors(const Results& results);  ///< some cell has an error.*
bool has_no_errors(const Results& results);
bool has_structures(const Results& results);      ///< some cell has a structure.*
bool has_adaptive_cells(const Results& results);  ///< steps of some cell are chosen to a tolerance
bool has_timed_cells(const Results& results);     ///< cells measure time and memory of their steps

struct ResultTable {
    std::string name;     ///< of its files, or their beginning where it comes in several
    std::string summary;  ///< a line for `kreisel list tables`
    int place = 0;        ///< tables are written and printed in ascending order of it; each has its own
    OfResults applies = always;
    OfResults is_printed = always;  ///< on the terminal, not only written
    bool repeats_cells = false;     ///< shows nothing but columns of all cells
    /// `folder` holds the results and their trajectories. A table without rows is not written.
    std::vector<TablePair> (*make)(const Results& results) = nullptr;
};

/// All of them, by `place`.
const std::vector<ResultTable>& result_tables();

/// Records a table; a static object of this type is what KREISEL_TABLE declares.
struct TableRegistration {
    explicit TableRegistration(ResultTable table);
};

}  // namespace kreisel

/// KREISEL_TABLE({.name = "orders", .summary = "...", .place = 30, .make = orders_tables}).
#define KREISEL_TABLE(...) KREISEL_REGISTER(::kreisel::TableRegistration, __VA_ARGS__)
