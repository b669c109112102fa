// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/linearise/linearise.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <cmath>

#include "driver/config/composition/composed.hpp"
#include "driver/config/shipped.hpp"
#include "driver/plan/plan.hpp"
#include "plots/tables/text.hpp"

namespace kreisel {

namespace {

// One start in one formulation.
struct LinearisedEntry {
    std::string problem, formulation;
    Linearisation result;
};

std::string motion_text(const Linearisation& result) {
    std::string text;
    for (const MotionPart& part : result.motion) {
        text += fmt::format("{}{}, {:.10g} {}", text.empty() ? "steady motion: " : "; ", part.name, part.rate.value,
                            part.unit);
    }
    return text.empty() ? "equilibrium" : text;
}

// Parts that cannot be told from zero are zero.
std::string part_text(const Number& part, const Linearisation& result) {
    return std::abs(part.value) <= 10 * result.uncertainty ? "0" : fmt::format("{:.14g}", part.value);
}

// The rows of a table of all: to read, and with every digit.
class EigenvalueTables {
  public:
    EigenvalueTables() {
        brief.columns = {"problem", "formulation", "directions", "real [1/s]", "imaginary [1/s]", "multiplicity"};
        full.columns = brief.columns;
        full.columns.insert(full.columns.end(), {"uncertainty [1/s]", "residual [1/s]", "rate [1/s]", "moves as"});
        brief.notes = {
            "Eigenvalues of the motion relative to the equilibrium or steady motion. Those along the orbit of the "
            "symmetries are apart; the others are of the motion up to symmetries, zeros among them of neighbouring "
            "steady motions."};
    }

    void add(const LinearisedEntry& entry) {
        add(entry, "across", entry.result.eigenvalues);
        add(entry, "symmetry", entry.result.of_symmetries);
    }

    TextTable brief{"linearisation", "Linearised motion", {}, {}};
    TextTable full{"linearisation", "Linearised motion", {}, {}};

  private:
    void add(const LinearisedEntry& entry, const std::string& directions, const std::vector<Eigenvalue>& eigenvalues) {
        const Linearisation& result = entry.result;
        for (const Eigenvalue& one : eigenvalues) {
            const std::string count = fmt::format("{}", one.multiplicity);
            brief.rows.push_back({entry.problem, entry.formulation, directions, part_text(one.real, result),
                                  part_text(one.imaginary, result), count});
            full.rows.push_back({entry.problem, entry.formulation, directions, one.real.text, one.imaginary.text, count,
                                 exact_number(result.uncertainty), result.residual.text, result.rate.text,
                                 motion_text(result)});
        }
    }
};

std::vector<LinearisedEntry> entries_of(const Plan& plan, const Engine& engine) {
    std::vector<LinearisedEntry> entries;
    for (const ProblemPoint& problem : plan.config.problems) {
        for (const std::string& formulation : plan.config.formulations) {
            entries.push_back(
                {problem.label(), formulation,
                 engine.linearise(problem.name(), problem.parameters(), formulation, plan.config.begin.get())});
        }
    }
    return entries;
}

// "heavy_top on SO3xR3", "heavy_top on SO3xR3 at t = 3 s".
std::string title(const LinearisedEntry& entry, const Config& config) {
    const std::string where = fmt::format("{} on {}", entry.problem, entry.formulation);
    return config.begin ? fmt::format("{} at t = {} s", where, config.begin->t.value) : where;
}

void print_entry(const LinearisedEntry& entry, const Config& config, std::ostream& out) {
    const Linearisation& result = entry.result;
    fmt::print(out, "{}: {}\n", title(entry, config), motion_text(result));
    fmt::print(out, "  missed by {:.1e} 1/s; {} dimensions on the constraints; eigenvalues to {:.1e} 1/s\n",
               result.residual.value, result.dimension, result.uncertainty);
}

}  // namespace

Exit linearise_command(const std::filesystem::path& config, const std::filesystem::path& output, const Engines& engines,
                       const Terminal& terminal) {
    const Plan plan = plan_of(composed_config(config_file(config)), engines);
    EigenvalueTables tables;
    std::string refusals;
    for (const LinearisedEntry& entry : entries_of(plan, engines.quad())) {
        const std::string& skip = entry.result.skip_reason;
        const std::string& refusal = entry.result.refusal;
        if (!skip.empty()) {
            fmt::print(terminal.out, "{}: skipped: {}\n", title(entry, plan.config), skip);
        } else if (!refusal.empty()) {
            refusals += fmt::format("{}{}: {}", refusals.empty() ? "" : "\n", title(entry, plan.config), refusal);
        } else {
            print_entry(entry, plan.config, terminal.out);
            tables.add(entry);
        }
    }
    if (!tables.brief.rows.empty()) {
        const TextTable shown = without_constant_columns(tables.brief, {"problem", "formulation"});
        terminal.out << "\n" << terminal_text(shown);
        if (!output.empty()) { write_table(output, tables.full, shown); }
    }
    if (!refusals.empty()) { throw UsageError(refusals); }
    return Exit::ok;
}

}  // namespace kreisel
