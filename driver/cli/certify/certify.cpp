// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/certify/certify.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <sstream>

#include "driver/cli/catalogue/methods.hpp"
#include "driver/cli/certify/findings.hpp"
#include "driver/cli/certify/sheet.hpp"
#include "driver/cli/certify/trials.hpp"
#include "plots/tables/table.hpp"
#include "records/json/diagnostics.hpp"
#include "support/nearest.hpp"

namespace kreisel {

namespace {

constexpr std::size_t digits_shown = 14;
constexpr int times_as_long = 100;

// Columns stated once, above a table, if they are the same in every row.
const std::vector<std::string> once = {"problem",   "formulation", "method", "projection",
                                       "precision", "steps",       "h [s]",  "status"};

// The trials, in the order of the sheet. Without steps of one size there is no map to look at, and no law of h.
struct SheetTrial {
    const char* config;
    bool needs_steps = false;
};
constexpr SheetTrial trials[] = {{"certified_orders"},
                                 {"certified_structure", true},
                                 {"certified_energy", true},
                                 {"certified_conservation"},
                                 {"certified_cost"}};

MethodDescription method_called(const std::string& name, const Engine& engine) {
    const auto methods = engine.methods();
    if (const auto* found = find_named(methods, name)) { return *found; }
    const std::string nearest = nearest_name(name, names_of(methods));
    throw UsageError(fmt::format("expected the name of a method (see kreisel list methods), got {}{}", in_quotes(name),
                                 nearest.empty() ? "" : "; did you mean " + in_quotes(nearest) + "?"));
}

std::string brief_coefficient(const std::string& text) {
    return text.size() <= digits_shown || text.find('/') != std::string::npos ? text
                                                                              : text.substr(0, digits_shown) + "...";
}

TextTable coefficients_of(const std::vector<SchemeRow>& scheme) {
    TextTable table{"coefficients", "Coefficients", {"row", "coefficients"}, {}};
    for (const SchemeRow& row : scheme) {
        std::vector<std::string> all;
        for (const std::string& one : row.coefficients) { all.push_back(brief_coefficient(one)); }
        table.rows.push_back({row.label, fmt::format("{}", fmt::join(all, ", "))});
    }
    return table;
}

// On the test rotation, which is one system and needs no campaign.
TextTable stability_of(const RotationStability& found) {
    TextTable table{"stability", "Stability on a test rotation", {"largest h Omega", "|mu| - 1 at h Omega = 1/2"}, {}};
    table.notes = {
        "Small rotations of a body about a fixed axis under the torque -J Omega^2 theta, in quad: the largest h Omega "
        "up "
        "to which no eigenvalue mu of a step, of a method with memory of the recurrence of its steps, is larger than "
        "1."};
    if (!found.refusal.empty()) {
        table.columns = {"not defined"};
        table.rows.push_back({found.refusal});
        return table;
    }
    const std::string limit =
        found.bounded ? fmt::format("{:.4f}", found.limit) : fmt::format("none up to {:.0f}", found.limit);
    table.rows.push_back({limit, fmt::format("{:+.2e}", found.growth)});
    return table;
}

// What `kreisel table` would print of the results, and orders at a glance.
void add_tables(const Results& results, DataSheet& sheet) {
    for (const ResultTable& table : result_tables()) {
        const bool shown = table.is_printed(results) || table.name == "certification";
        if (!shown || !table.applies(results)) { continue; }
        for (const TablePair& pair : table.make(results)) {
            if (!pair.brief().rows.empty()) { sheet.tables.push_back(without_constant_columns(pair.brief(), once)); }
        }
    }
}

// What did not run to its end, and orders that are marked as too low in the tables from `first` on, one line each.
std::vector<std::string> complaints_about(const Results& results, const DataSheet& sheet, std::size_t first) {
    std::vector<std::string> complaints;
    for (const ResultRow& row : results.rows) {
        if (row.ok() || row.status == "skipped") { continue; }
        complaints.push_back(fmt::format("{} on {}: {}: {}", row.label, row.formulation, row.status, row.detail));
    }
    for (std::size_t i = first; i < sheet.tables.size(); ++i) {
        const TextTable& table = sheet.tables[i];
        if (!table.name.starts_with("certification")) { continue; }
        for (const auto& row : table.rows) {
            const bool low = std::any_of(row.begin(), row.end(),
                                         [](const std::string& cell) { return cell.find('!') != std::string::npos; });
            if (low) { complaints.push_back("an order falls short of the declared one: " + table.title); }
        }
    }
    return complaints;
}

DataSheet described(const MethodDescription& method, const Engine& engine) {
    DataSheet sheet;
    sheet.title = method.name + ": " + method.summary;
    std::ostringstream text;
    describe_method(method, text);
    std::istringstream lines(text.str());
    std::string line;
    std::getline(lines, line);  // the title
    while (std::getline(lines, line)) { sheet.paragraphs.push_back(line); }
    const TextTable coefficients = coefficients_of(engine.scheme(method.name));
    if (!coefficients.rows.empty()) { sheet.tables.push_back(coefficients); }
    return sheet;
}

void append(std::vector<std::string>& all, std::vector<std::string> more) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
}

// Runs the trials into `folder`, and adds what they tell to the sheet; returns what speaks against the method.
std::vector<std::string> try_out(const MethodDescription& method, bool is_long, const std::filesystem::path& folder,
                                 const Engines& engines, std::ostream& messages, DataSheet& sheet) {
    std::vector<std::string> complaints;
    sheet.tables.push_back(stability_of(engines.quad().stability(method.name)));
    for (const SheetTrial& trial : trials) {
        const std::string name = trial.config;
        if (trial.needs_steps && method.own_control) {
            if (name == "certified_structure") { append(complaints, structure_findings(method, {}).complaints); }
            continue;
        }
        const int times = is_long && name == "certified_energy" ? times_as_long : 1;
        const Results results = run_trial(name, method, times, folder, engines, messages);
        const std::size_t before = sheet.tables.size();
        add_tables(results, sheet);
        append(complaints, complaints_about(results, sheet, before));
        Findings found;
        if (name == "certified_structure") { found = structure_findings(method, results); }
        if (name == "certified_energy") { found = energy_findings(method, results); }
        append(sheet.remarks, found.remarks);
        append(complaints, found.complaints);
    }
    return complaints;
}

}  // namespace

Exit certify_command(const std::string& name, bool is_long, const std::filesystem::path& output, const Engines& engines,
                     const Terminal& terminal) {
    const MethodDescription method = method_called(name, engines.binary64);
    DataSheet sheet = described(method, engines.binary64);
    if (!output.empty()) { require_own_sheet(output, method.name); }
    const TemporaryFolder folder;
    std::vector<std::string> complaints;
    try {
        complaints = try_out(method, is_long, folder.path(), engines, terminal.messages, sheet);
    } catch (const TrialInterrupted&) { return Exit::interrupted; }
    terminal.out << terminal_text(sheet);
    if (!output.empty()) { write_sheet(output, method.name, sheet); }
    for (const std::string& one : complaints) { fmt::print(terminal.messages, "not certified: {}\n", one); }
    return complaints.empty() ? Exit::ok : Exit::cells_failed;
}

}  // namespace kreisel
