// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/options/slurm.hpp"

#include <fmt/format.h>

#include "driver/cli/slurm/time_limit.hpp"
#include "records/json/diagnostics.hpp"

namespace kreisel {

namespace {

std::string time_limit(const std::string& written) {
    if (slurm_seconds(written)) { return ""; }
    return fmt::format("expected a time as Slurm writes it (30, 30:00, 2:30:00 or 1-12), got {}", in_quotes(written));
}

std::string option_of_sbatch(const std::string& written) {
    if (written.starts_with("-")) { return ""; }
    return fmt::format("expected --OPTION or --OPTION=VALUE for sbatch after --, got {}", in_quotes(written));
}

}  // namespace

void add_slurm(CommandLine& line) {
    SlurmSettings& settings = line.arguments().slurm;
    CLI::App* slurm = line.command("slurm", "Writes the script that runs a config on a Slurm cluster", [&line] {
        return slurm_command(line.arguments().config, line.arguments().changes, line.arguments().output,
                             line.arguments().slurm, line.engines(), line.terminal());
    });
    slurm->add_option("config", line.arguments().config, config_help)->required();
    slurm->add_option("sbatch", settings.options, "After --: options of sbatch for all jobs, such as --partition=long")
        ->check(option_of_sbatch);
    slurm->add_option("-o,--output", line.arguments().output,
                      "Folder for the script, its logs and the results (default: results/<name>), which all nodes see");
    slurm
        ->add_option("--shards", settings.parts,
                     "Parts, each a job of an array (default: 10, or as many as there are cells)")
        ->check(CLI::Range(std::size_t{1}, std::size_t{1000000}));
    slurm
        ->add_option("--time", settings.time,
                     "Time limit of a job, as Slurm writes it (default: the cluster's). A minute before it, jobs end\n"
                     "what they do and go on in a new run")
        ->check(time_limit);
    slurm
        ->add_option("--cpus", settings.cpus,
                     "Processors of each job, and cells computed at the same time (default: 1)")
        ->check(CLI::Range(1U, 4096U));
    slurm
        ->add_option("--timeout", settings.timeout,
                     "Seconds of CPU time that a cell or a reference may take; by default as many as it needs")
        ->check(CLI::PositiveNumber);
    slurm->add_flag("--submit", settings.submit, "Submit it as well");
    line.add_changes(*slurm);
    slurm->footer(
        "It writes DIR/config.json, the config as resolved, and DIR/submit.sh: a job for the references, an array of\n"
        "parts after it, and a merge. To submit it again is to go on.");
}

}  // namespace kreisel
