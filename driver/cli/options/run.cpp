// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/options/run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <sstream>

#include "driver/campaign/campaign.hpp"
#include "driver/campaign/workers/parent.hpp"
#include "records/provenance.hpp"

namespace kreisel {

namespace {

// "I/N".
void read_shard(const std::string& written, RunSettings& settings) {
    std::size_t shard = 0, shards = 0;
    char slash = 0, rest = 0;
    std::istringstream text(written);
    const bool good = text >> shard >> slash >> shards && slash == '/' && !(text >> rest);
    if (!good || shard < 1 || shard > shards || written.find('-') != std::string::npos) {
        throw UsageError(fmt::format("--shard: expected I/N with 1 <= I <= N, got {}", in_quotes(written)));
    }
    settings.shard = shard;
    settings.shards = shards;
}

// Read as CLI11 has read it.
std::string above_zero(const std::string& written) {
    double value = 0;
    const bool good = CLI::detail::lexical_cast(written, value) && value > 0 && std::isfinite(value);
    return good ? "" : fmt::format("expected a number above 0, got {}", in_quotes(written));
}

void add_limits(CommandLine& line, CLI::App& run) {
    RunSettings& settings = line.arguments().settings;
    settings.workers = usual_workers();
    run.add_option("-j,--jobs", settings.workers, "Cells computed at the same time (default: all processors)")
        ->check(CLI::Range(1U, 4096U));
    run.add_option("--timeout", settings.timeout,
                   "Seconds of CPU time that a cell or a reference may take; by default as many as it needs")
        ->check(above_zero);
    run.add_option("--max-memory", settings.max_memory,
                   "Memory of all cells together, such as 8GB (default: 80 % of what the machine or its cgroup\n"
                   "allows); a cell that meets its share is run again alone with all of it")
        ->transform(CLI::AsSizeValue(false))
        ->check(above_zero);
}

}  // namespace

void add_run(CommandLine& line) {
    CLI::App* run = line.command(
        "run", "Runs configs: one journal line per finished cell, then results.jsonl and results.csv", [&line] {
            if (line.arguments().with_parent) { die_with(::getppid()); }
            read_shard(line.arguments().shard, line.arguments().settings);
            line.arguments().settings.build = build_id();
            line.arguments().settings.terminal = isatty(STDERR_FILENO) != 0;
            return run_command(line.arguments().configs, line.arguments().changes, line.arguments().output,
                               line.arguments().settings, line.engines(), line.terminal());
        });
    RunSettings& settings = line.arguments().settings;
    run->add_option("config", line.arguments().configs, config_help)->required();
    run->add_option(
        "-o,--output", line.arguments().output,
        "Folder for the results (default: results/<name>); with several configs, one folder in it for each");
    CLI::Option* resume =
        run->add_flag("--resume", settings.resume, "Keep what an earlier run of this build has finished");
    run->add_flag("--overwrite", settings.overwrite, "Remove the results of an earlier run first")->excludes(resume);
    run->add_option("--shard", line.arguments().shard,
                    "I/N: run only the I-th of N parts; kreisel merge puts them together");
    run->add_flag("--references-only", settings.references_only,
                  "Compute the reference solutions that cells need, and no cell");
    run->add_flag("--with-parent", line.arguments().with_parent,
                  "End when the process that has started it does, even by kill -9; --resume goes on");
    line.add_references(*run);
    add_limits(line, *run);
    line.add_changes(*run);
}

}  // namespace kreisel
