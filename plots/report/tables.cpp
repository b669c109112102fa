// SPDX-License-Identifier: BSD-3-Clause
#include "plots/report/tables.hpp"

#include <algorithm>
#include <vector>

#include "plots/report/cells.hpp"
#include "plots/tables/table.hpp"
#include "records/json/writer.hpp"

namespace kreisel {

namespace {

constexpr std::size_t room_for_tables = 1500000;  // bytes, beside that of all cells

struct NamedTable {
    bool last;  // repeats columns of all cells
    TextTable table;
};

std::vector<NamedTable> tables_of(const Results& results) {
    std::vector<NamedTable> all;
    for (const ResultTable& table : result_tables()) {
        if (!table.applies(results)) { continue; }
        for (TablePair& pair : table.make(results)) {
            const std::vector<std::string> notes = pair.brief().notes;
            pair.full.notes.insert(pair.full.notes.end(), notes.begin(), notes.end());
            if (!pair.full.rows.empty()) { all.push_back({table.repeats_cells, std::move(pair.full)}); }
        }
    }
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.last < b.last; });
    return all;
}

}  // namespace

std::string report_tables(const Results& results) {
    std::string list = json_value(cell_columns(all_cells(results), results.units));
    const std::size_t most = std::max(list.size(), room_for_tables);
    for (const auto& [last, table] : tables_of(results)) {
        std::string json = json_value(by_columns(table));
        if (list.size() + json.size() > most) {
            json = ObjectWriter()
                       .member("name", json_text(table.name))
                       .member("title", json_text(table.title))
                       .member("left_out", "true")
                       .text();
        }
        list += "," + json;
    }
    return "[" + list + "]";
}

}  // namespace kreisel
