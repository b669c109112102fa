// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "driver/cli/catalogue.hpp"
#include "driver/cli/merge.hpp"
#include "driver/cli/options/beginnings.hpp"
#include "driver/cli/options/inquiries.hpp"
#include "driver/cli/options/run.hpp"
#include "driver/cli/options/slurm.hpp"
#include "driver/cli/planned_cells.hpp"
#include "driver/cli/suggestions.hpp"
#include "driver/cli/verify/verify.hpp"
#include "driver/config/schema.hpp"
#include "kreisel_build.hpp"
#include "plots/plot.hpp"
#include "plots/report/report.hpp"
#include "plots/table.hpp"
#include "records/json/diagnostics.hpp"
#include "records/provenance.hpp"

namespace kreisel {

namespace {

constexpr const char* description =
    "kreisel: a testbed for Lie-group integrators of constrained multibody systems.\n"
    "An experiment is one JSON file that crosses problems, formulations, methods, projections and step sizes.\n"
    "Start with: kreisel list, then kreisel info heavy_top, then kreisel run orders_heavy_top";

constexpr const char* exit_codes =
    "Exit codes: 0 all cells ok or skipped with a reason; 1 some cells failed, a figure could not be drawn, or "
    "results\n"
    "differ (verify, diff), or something fails (doctor);\n"
    "2 bad config or usage, nothing was run; 3 a file or folder could not be read or written, or is damaged, no\n"
    "process could be started, memory ran out, or cells are missing (merge);\n"
    "4 internal error; 130 interrupted.";

}  // namespace

CommandLine::CommandLine(const Engines& engines, const Terminal& terminal)
    : engines_(engines), terminal_(terminal), app_(description, "kreisel") {
    app_.require_subcommand(1);
    app_.footer(exit_codes);
    app_.set_version_flag("--version", fmt::format("kreisel {} (commit {}, {}, {} {})", build::version, build::commit,
                                                   build::compiler, build::build_type, build::flags));
    add_catalogue();
    add_inquiries(*this);
    add_beginnings(*this);
    add_planning();
    add_run(*this);
    add_slurm(*this);
    add_results();
    add_diff();
}

Exit CommandLine::run(int argc, const char* const* argv) {
    try {
        app_.parse(argc, argv);
    } catch (const CLI::Success& success) {  // --help, --version
        app_.exit(success, terminal_.out, terminal_.messages);
        return Exit::ok;
    } catch (const CLI::ParseError& error) {
        if (argc > 1 && argv[1][0] != '-') { require_command(app_, argv[1]); }
        const std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
        throw UsageError(
            fmt::format("{}{}\nRun with --help for more information.", error.what(), suggestion(app_, words)));
    }
    return action_();
}

CLI::App* CommandLine::command(const std::string& name, const std::string& text, Action action) {
    CLI::App* sub = app_.add_subcommand(name, text);
    sub->callback([this, action = std::move(action)] { action_ = action; });
    return sub;
}

void CommandLine::add_catalogue() {
    CLI::App* list = command(
        "list", "What there is: problems, methods, projections, formulations, metrics, kinds, figures, tables, configs",
        [this] {
            list_topic(engines_.binary64, arguments_.topic, arguments_.filter, terminal_.out);
            return Exit::ok;
        });
    list->add_option("topic", arguments_.topic, "One of them; all if left out")
        ->check(CLI::IsMember(catalogue_topics()));
    add_filter(*this, *list);
    CLI::App* info = command(
        "info", "All about one problem, method, projection, formulation, metric, kind, figure or table", [this] {
            describe(engines_.binary64, arguments_.name, terminal_.out);
            return Exit::ok;
        });
    info->add_option("name", arguments_.name, "Its name, as kreisel list shows it")->required();
    command("schema", "The JSON Schema (draft-07) of a config, for editors and checkers", [this] {
        terminal_.out << config_schema(Catalogue(engines_.binary64)).dump(2) << "\n";
        return Exit::ok;
    });
}

void CommandLine::add_changes(CLI::App& sub) {
    sub.add_option("--set", arguments_.changes.settings,
                   "/POINTER=VALUE: one value of every config, such as /time/end=2 or /methods/0=rkmk/rk4;\n"
                   "VALUE is JSON, or else a text; may be given several times")
        ->expected(1)
        ->take_all();
    sub.add_option("--filter", arguments_.changes.filters,
                   "AXIS=PATTERN[,PATTERN...]: only what fits on the axis problems, formulations, methods,\n"
                   "projections or precision, such as methods=rkmk/*; may be given several times")
        ->expected(1)
        ->take_all();
}

void CommandLine::add_references(CLI::App& sub) {
    sub.add_option("--references", arguments_.settings.references,
                   "Results of a kreisel of the same sources: reference solutions that it has are not computed")
        ->check(CLI::ExistingDirectory);
}

void CommandLine::add_planning() {
    CLI::App* check = command("check", "Checks configs and their physics without running anything", [this] {
        return check_command(arguments_.configs, arguments_.changes, arguments_.settings.references, engines_,
                             terminal_);
    });
    check->add_option("config", arguments_.configs, config_help)->required();
    add_changes(*check);
    add_references(*check);
    CLI::App* plan = command("plan", "Shows the cells a config leads to, and why some are skipped", [this] {
        return plan_command(arguments_.configs.front(), arguments_.changes, arguments_.settings.references,
                            arguments_.json, engines_, terminal_);
    });
    plan->add_option("config", arguments_.configs, config_help)->required()->expected(1);
    plan->add_flag("--json", arguments_.json, "Print JSON instead of a table");
    add_changes(*plan);
    add_references(*plan);
}

void CommandLine::add_table() {
    const auto planned = [this] { return planned_cells(arguments_.folder, engines_); };
    CLI::App* sub = command("table", "Tables from results", [this, planned] {
        return arguments_.table.table.empty() ? table_command(arguments_.folder, planned)
                                              : chosen_table_command(arguments_.folder, arguments_.table, planned);
    });
    sub->add_option("folder", arguments_.folder, "A folder that kreisel run has written")->required();
    CLI::Option* table = sub->add_option("--table", arguments_.table.table,
                                         "Print one table instead of writing all, by the name of its files: errors");
    const auto of_table = [&](CLI::Option* option) { option->needs(table); };
    of_table(
        sub->add_option("--columns", arguments_.table.columns, "Its columns, in this order: method,h,error.position")
            ->delimiter(','));
    of_table(sub->add_option("--rows", arguments_.table.rows,
                             "COLUMN=PATTERN: its rows with such a text there, method='rkmk/*'; may be repeated"));
    of_table(sub->add_option("--names", arguments_.table.names,
                             "TEXT=NAME: how titles and texts are printed, rkmk/rk4=RKMK4; may be repeated"));
    of_table(sub->add_option("--format", arguments_.table.format, "Of the table")
                 ->check(CLI::IsMember(table_formats()))
                 ->capture_default_str());
}

void CommandLine::add_results() {
    const auto add_folder = [this](CLI::App* sub) {
        sub->add_option("folder", arguments_.folder, "A folder that kreisel run has written")->required();
    };
    CLI::App* merge =
        command("merge", "Puts the journals of shards together into results.jsonl and results.csv", [this] {
            return merge_command(arguments_.folders, arguments_.output, build_id(), arguments_.mixed, engines_,
                                 terminal_);
        });
    merge->add_option("folder", arguments_.folders, "Folders that kreisel run --shard has written")->required();
    merge->add_option("-o,--output", arguments_.output, "Folder for the results (default: the first folder)");
    merge->add_flag("--mixed", arguments_.mixed, "Take results of other builds and machines as well");
    const auto planned = [this] { return planned_cells(arguments_.folder, engines_); };
    add_table();
    CLI::App* plot = command("plot", "Figures from results", [this] {
        return plot_command({arguments_.folders, arguments_.figure, arguments_.output},
                            [this](const std::filesystem::path& folder) { return planned_cells(folder, engines_); });
    });
    plot->add_option("folder", arguments_.folders, "Folders that kreisel run has written")->required();
    plot->add_option("--figure", arguments_.figure,
                     "JSON file of a figure, or a list of them, as under \"figure\" in configs (default: those of\n"
                     "the config); asked for where there are several folders, whose cells it draws together");
    plot->add_option(
        "-o,--output", arguments_.output,
        "Folder in which figures/ and plotdata/ are written (default: the first folder); files there that\n"
        "are not of kreisel are refused");
    CLI::App* report = command("report", "One page (HTML) with results, tables, figures and motion", [this, planned] {
        return report_command(arguments_.folder, arguments_.output, planned);
    });
    add_folder(report);
    report->add_option(
        "-o,--output", arguments_.output,
        "File to write (default: report.html in the folder); one that is there and not of kreisel is refused");
    CLI::App* verify = command("verify", "Computes some cells again and compares them byte for byte", [this] {
        return verify_command(arguments_.folder, arguments_.cells, arguments_.seed, build_id(), engines_, terminal_);
    });
    add_folder(verify);
    verify->add_option("--cells", arguments_.cells, "How many, chosen at random (default: 20)");
    verify->add_option("--seed", arguments_.seed, "Seed of that choice (default: 1)");
}

void CommandLine::add_diff() {
    DiffSettings& settings = arguments_.diff;
    CLI::App* diff = command("diff", "Compares the results in two folders, cell by cell",
                             [this] { return diff_command(arguments_.diff, terminal_.out, terminal_.messages); });
    diff->add_option("A", settings.a, "A folder that kreisel run has written")->required();
    diff->add_option("B", settings.b, "Another one")->required();
    diff->add_option("--csv", settings.csv,
                     "Write every difference to this file; one that is there and not of kreisel is refused");
    diff->add_option("--within", settings.within,
                     "Take final states and metrics for the same up to this fraction of the scale of their\n"
                     "quantity in the cell, and leave out counts, constraints, references and samples");
    diff->footer(
        "Cells are matched by what was run, not by their hash. Times, hosts and builds are not compared.\n"
        "Exit codes: 0 the same; 1 different; 2 bad usage; 3 a folder holds no results, or is damaged.");
}

}  // namespace kreisel
