// SPDX-License-Identifier: BSD-3-Clause
//
// The command line: its commands, their options, and what each calls.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <string>

#include "driver/cli/catalogue/traits.hpp"
#include "driver/cli/commands.hpp"
#include "driver/cli/diff.hpp"
#include "driver/cli/slurm/slurm.hpp"
#include "plots/tables/choice.hpp"

namespace kreisel {

/// What the help says of configs.
inline constexpr const char* config_help =
    "JSON files, or names of configs that come with kreisel: NAME is NAME.json\n"
    "in or below $KREISEL_EXPERIMENTS, by default where kreisel is installed,\n"
    "or in the sources it was built from. A file of that path comes first.";

/// The values set by the command line.
struct Arguments {
    std::string topic, name, kind, shard = "1/1";
    MethodFilter filter;
    Paths configs, folders;
    ConfigChanges changes;
    std::filesystem::path config, folder, figure, output;
    RunSettings settings;
    DiffSettings diff;
    SlurmSettings slurm;
    TableChoice table;
    bool json = false, is_long = false, mixed = false, with_parent = false;
    std::size_t cells = 20;
    unsigned seed = 1;
};

class CommandLine {
  public:
    using Action = std::function<Exit()>;

    /// Both outlive this object.
    CommandLine(const Engines& engines, const Terminal& terminal);

    /// Carries out a command line. Throws UsageError for one that cannot be read, with the nearest name where a command
    /// or option is mistyped, and what the command throws.
    Exit run(int argc, const char* const* argv);

    // For the files of commands (driver/cli/options).
    /// A command, and what it does if it is the one given.
    CLI::App* command(const std::string& name, const std::string& text, Action action);
    /// Options of commands that read configs: --set and --filter, --references.
    void add_changes(CLI::App& sub);
    void add_references(CLI::App& sub);
    Arguments& arguments() { return arguments_; }
    const Engines& engines() const { return engines_; }
    const Terminal& terminal() const { return terminal_; }

  private:
    void add_catalogue();
    void add_planning();
    void add_results();
    void add_table();
    void add_diff();

    const Engines& engines_;
    const Terminal& terminal_;
    CLI::App app_;
    Arguments arguments_;
    Action action_;
};

}  // namespace kreisel
