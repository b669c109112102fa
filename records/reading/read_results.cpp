// SPDX-License-Identifier: BSD-3-Clause
#include "records/reading/read_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <stdexcept>
#include <unordered_set>

#include "records/folder/damage.hpp"
#include "records/journal.hpp"
#include "records/json/strict.hpp"
#include "records/kinds/kind.hpp"
#include "records/manifest.hpp"
#include "records/sums/summed_text.hpp"
#include "support/errors.hpp"
#include "support/files.hpp"
#include "support/paths/at_path.hpp"

namespace kreisel {

namespace {

// What rows have alike is kept once.
class Sharing {
  public:
    void share(ResultRow& row) {
        for (NamedNumbers* numbers : {&row.metrics, &row.reference_error, &row.scale, &row.cost}) {
            numbers->share_names(names_);
        }
        for (auto* texts : {&row.options, &row.projection_options, &row.digits, &row.unmeasured}) {
            texts_.share(*texts);
        }
        parameters_.share(row.parameters);
        orders_.share(row.declared_order);
        folders_.share(row.folder);
    }

  private:
    Pool<NamedNumbers::Names> names_;
    Pool<std::map<std::string, std::string>> texts_;
    Pool<std::string> parameters_;
    Pool<std::map<std::string, int>> orders_;
    Pool<std::filesystem::path> folders_;
};

// What differs from run to run is only in the journals.
void add_times(const std::filesystem::path& folder, const std::string& build, Sharing& sharing, Results& results) {
    const auto is_timed = [](const ResultRow& row) { return row.bodies > 0; };
    const ExperimentKind* kind = find_experiment_kind(results.kind);
    const bool timed =
        (kind != nullptr && kind->repeated) || std::any_of(results.rows.begin(), results.rows.end(), is_timed);
    if (build.empty() || !timed) { return; }
    JournalContents journals;
    try {
        journals = read_journals(folder, build);  // folder_damage tells of their damaged lines
    } catch (const FileError&) { return; }        // and of one that is no file
    const JournalLines lines = journals.lines();
    for (ResultRow& row : results.rows) {
        const auto found = journals.cells.find(row.cell);
        if (found == journals.cells.end()) { continue; }
        const CellTimes times = lines.record(found->second).times;
        if (times.step_s) { row.cost["step_s"] = *times.step_s; }
        if (times.memory) { row.cost["memory"] = *times.memory; }
        if (times.run_s) { row.cost["run_s"] = *times.run_s; }
        sharing.share(row);
    }
}

// The rest of the manifest, if it is one of kreisel.
std::optional<ManifestContents> contents_of(const std::filesystem::path& file) {
    try {
        return read_manifest(file);
    } catch (const UsageError&) { return std::nullopt; }
}

std::optional<ManifestContents> read_manifest_into(const std::filesystem::path& folder, Results& results) {
    const auto file = folder / "manifest.json";
    results.name = std::filesystem::absolute(folder).lexically_normal().filename().string();
    if (!is_taken(file)) { return std::nullopt; }
    nlohmann::json manifest;
    try {
        manifest = read_summed_manifest(file).value;
    } catch (const FileError&) { return std::nullopt; }  // folder_damage says so
    if (!manifest.is_object()) { return std::nullopt; }
    if (const auto units = manifest.find("units"); units != manifest.end()) { results.units = *units; }
    const auto config = manifest.find("config");
    if (config == manifest.end() || !config->is_object()) { return std::nullopt; }
    results.config = config->dump(2);
    const auto text = [&](const char* key, const std::string& absent) {
        const auto found = config->find(key);
        return found != config->end() && found->is_string() ? found->get<std::string>() : absent;
    };
    results.kind = text("kind", "");
    results.name = text("name", results.name);
    return contents_of(file);
}

// A trajectory that is not what its result says is not drawn.
void check_samples(const std::filesystem::path& folder, Results& results) {
    for (ResultRow& row : results.rows) {
        if (!row.has_trajectory || row.trajectory_sum.empty()) { continue; }
        std::string damage = trajectory_damage(folder, row.cell, row.trajectory_sum);
        if (damage.empty()) { continue; }
        row.has_trajectory = false;
        results.damage.push_back(std::move(damage));
    }
}

// A plan none of whose cells has a result is of another version, which names them otherwise.
void add_missing(const std::vector<CellIdentity>& planned, Sharing& sharing, Results& results) {
    std::set<std::string> known;
    for (const ResultRow& row : results.rows) { known.insert(row.cell); }
    for (const CellIdentity& cell : planned) {
        if (known.contains(cell.cell)) { continue; }
        CellRecord record{cell, {}, {}};
        record.outcome.status = "missing";
        record.outcome.detail = "no result";
        sharing.share(results.missing.emplace_back(result_row(record)));
    }
    if (!results.rows.empty() && results.missing.size() == planned.size()) { results.missing.clear(); }
}

// One after the other, also a last one without an end: all together may take more memory than the rows.
template <class Visit>
void visit_lines(const std::filesystem::path& file, const Visit& visit) {
    for_each_line(
        file, [&](std::uint64_t, const std::string& line) { visit(line); }, TornLine::visited);
}

// Lines of this format have sums; where the format is not known one sum tells of all.
bool is_summed(const std::filesystem::path& file, bool known) {
    if (known) { return true; }
    bool summed = false;
    visit_lines(file, [&](const std::string& line) { summed = summed || sum_state(line) == SumState::holds; });
    return summed;
}

std::size_t count_lines(const std::filesystem::path& file) {
    std::size_t count = 0;
    visit_lines(file, [&](const std::string& /*line*/) { ++count; });
    return count;
}

// Returns how many lines there are.
std::size_t read_lines_into(const std::filesystem::path& folder, bool summed, Sharing& sharing, Results& results) {
    results.rows.reserve(count_lines(folder / "results.jsonl"));  // growing would take three times the rows
    const Shared<std::filesystem::path> shared_folder(folder);
    std::unordered_set<std::string> known;
    std::size_t number = 0;
    visit_lines(folder / "results.jsonl", [&](const std::string& line) {
        ++number;
        if (line.empty()) { return; }
        try {
            require_sum(line, summed);
            ResultRow read = read_result_line(line);
            if (!known.insert(read.cell).second) { throw std::invalid_argument(repeated_cell); }
            ResultRow& row = results.rows.emplace_back(std::move(read));
            row.folder = shared_folder;
            sharing.share(row);
        } catch (const std::exception& error) {
            results.damage.push_back(fmt::format("results.jsonl:{}: not a result line: {}", number, error.what()));
        }
    });
    return number;
}

std::vector<std::string> measured_metrics(const std::vector<ResultRow>& rows) {
    std::set<std::string> names;
    for (const ResultRow& row : rows) {
        for (const auto& [name, value] : row.metrics) { names.insert(name); }
    }
    return {names.begin(), names.end()};
}

}  // namespace

void require_results(const std::filesystem::path& folder) {
    std::error_code error;
    const auto file = folder / "results.jsonl";
    if (std::filesystem::exists(file, error)) { return; }
    throw FileError(fmt::format("{}: cannot be read: there is no such file{}", file.string(),
                                !shard_files(folder, "journal", ".jsonl").empty()
                                    ? "; the journal beside it is of a run that has not ended, or of "
                                      "a part: kreisel run --resume goes on, kreisel merge puts "
                                      "parts together"
                                    : ""));
}

std::string what_is_wanting(const Results& results) {
    std::vector<std::string> parts;
    const auto failed = std::count_if(results.rows.begin(), results.rows.end(),
                                      [](const ResultRow& row) { return !row.ok() && row.status != "skipped"; });
    const std::size_t all = results.rows.size() + results.missing.size();
    if (!results.missing.empty()) {
        parts.push_back(fmt::format("{} of {} cells missing", results.missing.size(), all));
    }
    if (failed > 0) { parts.push_back(fmt::format("{} of {} cells failed", failed, all)); }
    if (!results.damage.empty()) { parts.emplace_back("damaged results are left out"); }
    return fmt::format("{}", fmt::join(parts, ", "));
}

Results read_results(const std::filesystem::path& folder, const PlannedCells& planned) {
    Results results;
    const auto file = folder / "results.jsonl";
    const auto manifest = read_manifest_into(folder, results);
    const bool summed = is_summed(file, format_of(folder) >= folder_format);
    results.warning = summed ? "" : format_warning(folder);
    Sharing sharing;
    const std::size_t lines = read_lines_into(folder, summed, sharing, results);
    if (manifest) {
        std::string missing = missing_lines(file, lines, *manifest);
        if (!missing.empty()) { results.damage.push_back(std::move(missing)); }
    }
    for (std::string& text : folder_damage(folder)) { results.damage.push_back(std::move(text)); }
    check_samples(folder, results);
    if (manifest && planned && results.rows.size() < manifest->state.counts.total) {
        add_missing(planned(), sharing, results);
    }
    add_times(folder, manifest ? manifest->state.build : "", sharing, results);
    if (results.units.empty()) { results.units = units_before_format_2(measured_metrics(results.rows)); }
    return results;
}

}  // namespace kreisel
