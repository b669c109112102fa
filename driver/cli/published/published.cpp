// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/published/published.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "driver/cli/certify/trials.hpp"
#include "driver/cli/published/agreement.hpp"
#include "driver/config/composed.hpp"
#include "driver/config/shipped.hpp"
#include "driver/plan/plan.hpp"
#include "plots/tables/text.hpp"
#include "support/csv.hpp"
#include "support/files.hpp"

namespace kreisel {

namespace {

using Values = std::vector<std::string>;  ///< of one quantity, of each cell or formulation

// What the configs give, each run once.
class PublishedRuns {
  public:
    PublishedRuns(const Engines& engines, std::ostream& messages) : engines_(engines), messages_(messages) {}

    /// Throws UsageError where the config has no such quantity.
    Values find(const PublishedValue& value) {
        const Values found = value.column.starts_with("eigenvalue.") ? eigenvalues(value) : cells(value);
        if (found.empty()) {
            throw UsageError(
                fmt::format("{}: expected a cell that is ok, with a column {}", value.config, value.column));
        }
        return found;
    }

  private:
    const Plan& plan(const std::string& config) {
        const auto known = plans_.find(config);
        if (known != plans_.end()) { return known->second; }
        return plans_.emplace(config, plan_of(composed_config(config_file(config)), engines_)).first->second;
    }

    Values cells(const PublishedValue& value) {
        auto& table = tables_[value.config];
        if (table.empty()) {
            run_plan(plan(value.config), folder_.path() / value.config, engines_, messages_);
            table = read_csv(read_text(folder_.path() / value.config / "results.csv"));
        }
        const auto column_of = [&](const std::string& title) {
            return static_cast<std::size_t>(std::find(table[0].begin(), table[0].end(), title) - table[0].begin());
        };
        const std::size_t column = column_of(value.column), status = column_of("status");
        Values found;
        for (std::size_t i = 1; i < table.size() && column < table[0].size(); ++i) {
            if (table[i].at(status) == "ok" && !table[i].at(column).empty()) { found.push_back(table[i][column]); }
        }
        return found;
    }

    // "eigenvalue.3.real": the third.
    Values eigenvalues(const PublishedValue& value) {
        std::istringstream words(value.column.substr(value.column.find('.') + 1));
        std::size_t place = 0;
        char dot = 0;
        std::string part;
        words >> place >> dot >> part;
        Values found;
        for (const Linearisation& one : linearised(value.config)) {
            if (place < 1 || place > one.eigenvalues.size()) { continue; }
            const Eigenvalue& eigenvalue = one.eigenvalues[place - 1];
            found.push_back(part == "imaginary" ? eigenvalue.imaginary.text : eigenvalue.real.text);
        }
        return found;
    }

    const std::vector<Linearisation>& linearised(const std::string& config) {
        std::vector<Linearisation>& all = linearised_[config];
        if (!all.empty()) { return all; }
        const Config& read = plan(config).config;
        for (const ProblemEntry& problem : read.problems) {
            for (const std::string& formulation : read.formulations) {
                all.push_back(engines_.binary128.linearise(problem.name, problem.parameters, formulation));
            }
        }
        return all;
    }

    const Engines& engines_;
    std::ostream& messages_;
    TemporaryFolder folder_;
    std::map<std::string, Plan> plans_;
    std::map<std::string, std::vector<std::vector<std::string>>> tables_;
    std::map<std::string, std::vector<Linearisation>> linearised_;
};

struct ComparedValue {
    long double ours = 0;
    int digits = 0;
};

// Of several values the one that agrees least.
ComparedValue compared(const PublishedValue& value, const Values& found) {
    ComparedValue worst;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const long double ours = std::stold(found[i]) / value.factor;
        const int digits = agreeing_digits(value.printed, ours);
        if (i == 0 || digits < worst.digits) { worst = {ours, digits}; }
    }
    return worst;
}

TextTable empty_table() {
    TextTable table{"published", "Published numbers, and ours", {}, {}};
    table.columns = {"config", "quantity", "printed", "here", "digits", "source", "remark"};
    table.notes = {"Digits that agree, of those printed; of several formulations, those of the one that agrees least."};
    return table;
}

}  // namespace

Exit published_command(const std::filesystem::path& output, const Engines& engines, const Terminal& terminal) {
    const auto values = read_published_values(shipped_folder() / "published" / "published.csv");
    TextTable table = empty_table();
    std::string complaints;
    try {
        PublishedRuns runs(engines, terminal.messages);
        for (const PublishedValue& value : values) {
            const ComparedValue result = compared(value, runs.find(value));
            const int all = significant_digits(value.printed);
            table.rows.push_back({value.config, value.column, value.printed, fmt::format("{:.{}Lg}", result.ours, all),
                                  fmt::format("{} of {}", result.digits, all), value.source, value.remark});
            if (result.digits < value.digits) {
                complaints += fmt::format("{}: {}: expected {} digits of {}, got {}: {:.18Lg}\n", value.config,
                                          value.column, value.digits, value.printed, result.digits, result.ours);
            }
        }
    } catch (const TrialInterrupted&) { return Exit::interrupted; }
    terminal.out << terminal_text(table);
    if (!output.empty()) { write_table(output, table, table); }
    terminal.messages << complaints;
    return complaints.empty() ? Exit::ok : Exit::cells_failed;
}

}  // namespace kreisel
