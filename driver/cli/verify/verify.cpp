// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/verify/verify.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <random>
#include <set>
#include <sstream>

#include "driver/cli/verify/recomputer.hpp"
#include "records/cell/stepping.hpp"
#include "records/folder/damage.hpp"
#include "records/json/writer.hpp"
#include "records/metrics/catalogue.hpp"
#include "records/reference_store.hpp"
#include "records/sums/summed_text.hpp"
#include "support/files.hpp"
#include "support/number_text.hpp"

namespace kreisel {

namespace {

/// The result lines of a folder by cell, without their sums, and what is damaged.
struct StoredLines {
    std::map<std::string, std::string> texts;
    std::set<std::string> of_limits;  // which are not computed again
    std::vector<std::string> damage;
};

void read_stored_line(const std::string& line, bool summed, const std::filesystem::path& folder, StoredLines& stored) {
    require_sum(line, summed);
    const CellRecord record = read_record(line);
    const std::string& cell = record.identity.cell;
    if (!is_cell_name(cell)) { throw std::invalid_argument("the cell's name is not a hash"); }
    if (stored.texts.contains(cell)) { throw std::invalid_argument(repeated_cell); }
    stored.texts[cell] = sum_state(line) == SumState::holds ? std::string(before_sum(line)) + "}" : line;
    if (status::is_of_limits(record.outcome.status)) { stored.of_limits.insert(cell); }
    if (record.outcome.trajectory_sum.empty()) { return; }
    std::string damage = trajectory_damage(folder, cell, record.outcome.trajectory_sum);
    if (!damage.empty()) { stored.damage.push_back(std::move(damage)); }
}

StoredLines stored_lines(const std::filesystem::path& folder, const ManifestContents& manifest) {
    const auto file = folder / "results.jsonl";
    std::istringstream stream(read_text(file));
    StoredLines stored{{}, {}, folder_damage(folder)};
    std::size_t number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        try {
            read_stored_line(line, manifest.format >= folder_format, folder, stored);
        } catch (const std::invalid_argument& error) {  // its cell then counts as missing
            stored.damage.push_back(fmt::format("{}:{}: not a result line: {}", file.string(), number, error.what()));
        }
    }
    std::string missing = missing_lines(file, number, manifest);
    if (!missing.empty()) { stored.damage.push_back(std::move(missing)); }
    return stored;
}

std::vector<std::size_t> chosen(const Plan& plan, const std::set<std::string>& left_out, std::size_t count,
                                unsigned seed) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const PlannedCell& planned = plan.cells[i];
        if (planned.skip_reason().empty() && !left_out.contains(planned.hash())) { indices.push_back(i); }
    }
    std::mt19937 random(seed);
    std::shuffle(indices.begin(), indices.end(), random);
    indices.resize(std::min(count, indices.size()));
    return indices;
}

/// What is wrong with a reference: the first quantity that differs from the second route by more than its bound. Other
/// compilers and machines round differently, for which a factor of ten is allowed.
std::string fault(const std::map<std::string, Number>& error, const std::map<std::string, Number>& difference) {
    constexpr double slack = 10;
    for (const auto& [metric, bound] : error) {
        if (is_largest_error(metric)) { continue; }
        const auto found = difference.find(metric);
        if (found == difference.end()) { return fmt::format("{} cannot be compared", metric); }
        if (!(found->second.value <= slack * bound.value)) {
            return fmt::format("{} is off by {}, its bound is {}", metric, rounded_text(found->second.value, 1),
                               rounded_text(bound.value, 1));
        }
    }
    return "";
}

/// The same of the samples, then of the end.
std::string fault(const Reference& reference, const ReferenceCheck& check) {
    for (std::size_t i = 0; i < reference.samples.size(); ++i) {
        const ReferenceSample& sample = reference.samples[i];
        const std::string what = fault(sample.error, check.samples.at(i));
        if (!what.empty()) { return fmt::format("at the sample of {} s {}", sample.state.t.value, what); }
    }
    return fault(reference.error, check.difference);
}

/// All numbers of a reference, in full precision.
std::string numbers_of(const Reference& reference) {
    std::string text = fmt::format("{} {}", reference.route, json_number(reference.horizon));
    const auto add = [&](const ReportedState& state, const std::map<std::string, Number>& error) {
        text += " " + json_value(state, true);
        for (const auto& [metric, bound] : error) { text += fmt::format(" {} {}", metric, bound.text); }
    };
    add(reference.state, reference.error);
    for (const ReferenceSample& sample : reference.samples) { add(sample.state, sample.error); }
    return text;
}

/// The verdicts on the references of a folder.
struct ReferenceCounts {
    std::size_t confirmed = 0, wrong = 0, again = 0, different = 0;
};

/// Counts one reference and prints its verdict.
void verify_reference(const std::string& hash, const PlannedReference& planned, const std::filesystem::path& folder,
                      const Engine& engine, std::ostream& out, ReferenceCounts& counts) {
    const auto say = [&](const std::string& what) {
        fmt::print(out, "reference {}: {} at t = {} s: {}\n", hash, planned.problem, planned.t_end, what);
    };
    const auto file = reference_file(folder, hash);
    const auto stored = load_reference(file, planned, "");
    if (!stored) { return ++counts.wrong, say("missing or damaged"); }
    const ReferenceCheck check =
        engine.check_reference(planned.problem, planned.parameters, planned.begin.get(), stored->reference);
    if (!check.failure.empty()) {
        say("not compared: " + check.failure);
    } else if (const std::string what = fault(stored->reference, check); !what.empty()) {
        return ++counts.wrong, say(what);
    } else {
        ++counts.confirmed;
    }
    if (!load_reference(file, planned, engine.reference_digest())) { return; }  // other code rounds differently
    ++counts.again;
    const Reference again =
        engine.reference(planned.problem, planned.parameters, planned.begin.get(), planned.t_end, planned.samples, {});
    if (numbers_of(again) != numbers_of(stored->reference)) { ++counts.different, say("comes out different"); }
}

/// Compares every stored reference with the second route, and recomputes those made by this code; returns how many are
/// missing, damaged or wrong.
std::size_t verify_references(const Plan& plan, const std::filesystem::path& folder, const Engines& engines,
                              std::ostream& out) {
    if (!engines.has_quad()) {
        fmt::print(out, "{} references are not verified: this program is built without quad precision\n",
                   plan.references.size());
        return 0;
    }
    ReferenceCounts counts;
    for (const auto& [hash, planned] : plan.references) {
        verify_reference(hash, planned, folder, engines.quad(), out, counts);
    }
    fmt::print(out, "{} of {} references confirmed by the second route, {} wrong or missing\n", counts.confirmed,
               plan.references.size(), counts.wrong);
    fmt::print(out, "{} of {} references computed again, {} differ\n", counts.again, plan.references.size(),
               counts.different);
    return counts.wrong + counts.different;
}

// Computes cells again and names those whose line is missing or another; returns how many.
std::size_t verify_cells(const Plan& plan, const std::vector<std::size_t>& indices, Recomputer& recomputer,
                         const std::map<std::string, std::string>& lines, std::ostream& out) {
    std::size_t different = 0;
    for (const std::size_t index : indices) {
        const PlannedCell& planned = plan.cells[index];
        const auto stored = lines.find(planned.hash());
        const std::string what = stored == lines.end()                        ? "missing"
                                 : stored->second == recomputer.result(index) ? ""
                                                                              : "different";
        if (what.empty()) { continue; }
        ++different;
        fmt::print(out, "{}: {} {} on {}, {}: {}\n", planned.hash(), planned.cell().formulation, planned.cell().method,
                   planned.label(), stepping_text(planned.cell()), what);
    }
    return different;
}

}  // namespace

Exit verify_command(const std::filesystem::path& folder, std::size_t count, unsigned seed, const std::string& build,
                    const Engines& engines, const Terminal& terminal) {
    const ManifestContents manifest = read_manifest(manifest_file(folder, ""));
    if (manifest.state.build != build) {
        fmt::print(terminal.messages, "{}: note: written by build {}, verified by build {}\n", folder.string(),
                   manifest.state.build, build);
    }
    if (manifest.format < folder_format) { fmt::print(terminal.messages, "{}\n", format_warning(folder)); }
    const Plan plan = plan_of(manifest.config, engines);
    const auto [lines, of_limits, damage] = stored_lines(folder, manifest);
    for (const std::string& text : damage) { fmt::print(terminal.messages, "{}\n", text); }
    const auto indices = chosen(plan, of_limits, count, seed);
    if (!of_limits.empty()) {
        fmt::print(terminal.out, "{} cells that met a limit or have no reference are not computed again\n",
                   of_limits.size());
    }
    Recomputer recomputer(plan, folder, engines);
    const std::size_t different = verify_cells(plan, indices, recomputer, lines, terminal.out);
    fmt::print(terminal.out, "{} of {} cells computed again (seed {}), {} differ or are missing\n", indices.size(),
               plan.cells.size(), seed, different);
    const std::size_t wrong = plan.references.empty() ? 0 : verify_references(plan, folder, engines, terminal.out);
    if (!damage.empty()) { return Exit::io; }
    return different + wrong > 0 ? Exit::cells_failed : Exit::ok;
}

}  // namespace kreisel
