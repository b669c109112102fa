// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/published/published.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>

#include "driver/cli/published/agreement.hpp"
#include "driver/cli/published/runs.hpp"
#include "driver/config/shipped.hpp"
#include "plots/tables/text.hpp"

namespace kreisel {

namespace {

struct ComparedValue {
    long double ours = 0;
    int digits = 0;
};

bool is_order(const PublishedValue& value) { return value.column.starts_with("order."); }

// Of several values the one that agrees least.
ComparedValue compared(const PublishedValue& value, const std::vector<std::string>& found) {
    ComparedValue worst;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const long double ours = std::stold(found[i]) / value.factor;
        const int digits = is_order(value) ? agreeing_order(value.printed, ours) : agreeing_digits(value.printed, ours);
        if (i == 0 || digits < worst.digits) { worst = {ours, digits}; }
    }
    return worst;
}

TextTable empty_table() {
    TextTable table{"published", "Published numbers, and ours", {}, {}};
    table.columns = {"config", "quantity", "printed", "here", "digits", "source", "remark"};
    table.notes = {
        "Digits that agree, of those printed; of several formulations, those of the one that agrees least. Orders "
        "agree within 0.1, from 6 on within 0.2. Where a source has no digits, `kreisel run` and `kreisel plot` "
        "draw a figure of the same shape."};
    return table;
}

std::string quantity_text(const PublishedValue& value) {
    return value.column + (value.cells.empty() ? "" : ", " + value.cells);
}

// Adds the row of a value; returns what is wrong with it, a line, or nothing.
std::string compare(const PublishedValue& value, PublishedRuns& runs, TextTable& table) {
    if (value.column == figure_column) {
        table.rows.push_back(
            {value.config, "figure", "a figure", "of the same shape", "-", value.source, value.remark});
        return "";
    }
    const ComparedValue result = compared(value, runs.find(value));
    const int all = significant_digits(value.printed);
    const std::string ours =
        is_order(value) ? fmt::format("{:.2Lf}", result.ours) : fmt::format("{:.{}Lg}", result.ours, all);
    table.rows.push_back({value.config, quantity_text(value), value.printed, ours,
                          fmt::format("{} of {}", result.digits, all), value.source, value.remark});
    if (result.digits >= value.digits) { return ""; }
    return fmt::format("{}: {}: expected {} digits of {}, got {}: {:.18Lg}\n", value.config, quantity_text(value),
                       value.digits, value.printed, result.digits, result.ours);
}

}  // namespace

Exit published_command(const std::filesystem::path& output, const Engines& engines, const Terminal& terminal) {
    const auto values = read_published_values(shipped_folder() / "published" / "published.csv");
    TextTable table = empty_table();
    std::string complaints;
    try {
        PublishedRuns runs(engines, terminal.messages);
        for (const PublishedValue& value : values) { complaints += compare(value, runs, table); }
    } catch (const TrialInterrupted&) { return Exit::interrupted; }
    terminal.out << terminal_text(table);
    if (!output.empty()) { write_table(output, table, table); }
    terminal.messages << complaints;
    return complaints.empty() ? Exit::ok : Exit::cells_failed;
}

}  // namespace kreisel
