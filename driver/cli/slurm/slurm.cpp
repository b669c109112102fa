// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/slurm/slurm.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "driver/cli/read_plans.hpp"
#include "driver/cli/slurm/script.hpp"
#include "driver/cli/slurm/time_limit.hpp"
#include "driver/config/resolved.hpp"
#include "driver/plan/estimate/amounts.hpp"
#include "driver/plan/shards.hpp"
#include "driver/plan/text.hpp"
#include "records/provenance.hpp"
#include "support/files.hpp"
#include "support/in_shell.hpp"

namespace kreisel {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t usual_parts = 10;
constexpr double announced = 60;  // s before the limit that jobs are told of it

std::size_t parts_of(const Plan& plan, const SlurmSettings& settings) {
    const std::size_t cells = std::max<std::size_t>(1, plan.cells.size() - plan.skipped());
    if (settings.parts == 0) { return std::min(usual_parts, cells); }
    if (settings.parts > cells) {
        throw UsageError(
            fmt::format("--shards: expected at most {}, the cells that are to run, got {}", cells, settings.parts));
    }
    return settings.parts;
}

// CPU seconds, as estimated: of the references, of the dearest part, and of what cannot be divided.
struct Costs {
    double references = 0, part = 0, dearest = 0;
};

Costs costs_of(const Plan& plan, std::size_t parts) {
    Costs costs;
    for (const auto& [hash, reference] : plan.references) {
        costs.references += reference.weight;
        costs.dearest = std::max(costs.dearest, reference.weight);
    }
    for (std::size_t part = 1; part <= parts; ++part) {
        double sum = 0;
        for (const std::size_t i : cells_of_shard(plan, part, parts)) {
            sum += plan.cells[i].weight;
            costs.dearest = std::max(costs.dearest, plan.cells[i].weight);
        }
        costs.part = std::max(costs.part, sum);
    }
    return costs;
}

void warn_of_time(const Costs& costs, const SlurmSettings& settings, std::ostream& messages) {
    const auto limit = slurm_seconds(settings.time);
    if (!limit || costs.dearest <= *limit - announced) { return; }
    fmt::print(messages,
               "warning: --time {}: some cell or reference may take {} by itself (an estimate), and a limit cuts off "
               "what begins anew in the next run\n",
               settings.time, duration_text(costs.dearest));
}

std::vector<std::string> sbatch_options(const Plan& plan, const SlurmSettings& settings) {
    std::vector<std::string> options = {"--ntasks=1", fmt::format("--cpus-per-task={}", settings.cpus)};
    if (!settings.time.empty()) { options.push_back("--time=" + settings.time); }
    if (plan.config.runs_alone()) { options.emplace_back("--exclusive"); }  // its CPU times are measured
    options.insert(options.end(), settings.options.begin(), settings.options.end());
    return options;
}

std::string text_of(const fs::path& file) { return fs::exists(file) ? read_text(file) : ""; }

// sbatch writes no log below a folder with this sign.
void require_no_backslash(const fs::path& folder) {
    if (folder.string().find('\\') == std::string::npos) { return; }
    throw UsageError(fmt::format("{}: expected a folder without a backslash in its path, which Slurm cannot write to",
                                 folder.string()));
}

// Both files are replaced only as this command has written them.
void require_ours(const fs::path& folder) {
    const std::string script = text_of(folder / "submit.sh"), config = text_of(folder / "config.json");
    const auto refuse = [&](const char* name) {
        throw UsageError(
            fmt::format("{}: expected nothing at this name, or what kreisel slurm has written, got another "
                        "or a changed file; please move it away",
                        (folder / name).string()));
    };
    if (!script.empty() && !is_submit_script(script)) { refuse("submit.sh"); }
    if (!config.empty() && !is_script_of(script, config)) { refuse("config.json"); }
}

void write_files(const ClusterJob& job, const std::string& config) {
    const fs::path script = job.folder / "submit.sh";
    write_atomically(job.folder / "config.json", config);
    write_atomically(script, submit_script(job, config));
    fs::permissions(script, fs::perms::owner_exec, fs::perm_options::add);
}

void submit(const std::string& command) {
    // No other thread is there.
    if (const int code = std::system(command.c_str()); code != 0) {  // NOLINT(cert-env33-c,concurrency-mt-unsafe)
        throw FileError(fmt::format("{}: has failed; nothing, or a part of the jobs, is submitted", command));
    }
}

}  // namespace

Exit slurm_command(const fs::path& written, const ConfigChanges& changes, const fs::path& output,
                   const SlurmSettings& settings, const Engines& engines, const Terminal& terminal) {
    const Plan plan = read_plans(config_files({written}), changes, {}, engines, terminal.messages).front();
    const fs::path given = output.empty() ? fs::path("results") / plan.config.name : output;
    const std::size_t parts = parts_of(plan, settings);
    check_output_folder(given, plan, {.resume = true, .shard = 1, .shards = parts});
    require_no_backslash(fs::absolute(given));
    require_ours(given);
    ClusterJob job{plan.config.name,
                   program_file(),
                   fs::absolute(given).lexically_normal(),
                   parts,
                   plan.references.size(),
                   {},
                   sbatch_options(plan, settings)};
    if (settings.timeout > 0) { job.limits = {"--timeout", fmt::format("{}", settings.timeout)}; }
    make_folder(given);
    write_files(job, resolved_config(plan.config) + "\n");
    const Costs costs = costs_of(plan, parts);
    warn_of_time(costs, settings, terminal.messages);
    const std::string command = "bash " + in_shell((given / "submit.sh").string());
    fmt::print(terminal.out, "{}: {}; {} part{} of up to {} on {} processor{} (an estimate)\n", plan.config.name,
               plan_summary(plan), parts, parts == 1 ? "" : "s", duration_text(costs.part / settings.cpus),
               settings.cpus, settings.cpus == 1 ? "" : "s");
    if (!settings.submit) {
        fmt::print(terminal.out, "submit with: {}\n", command);
        return Exit::ok;
    }
    terminal.out.flush();
    submit(command);
    return Exit::ok;
}

}  // namespace kreisel
