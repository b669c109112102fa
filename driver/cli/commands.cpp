// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/commands.hpp"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <span>

#include "driver/campaign/interrupt.hpp"
#include "driver/campaign/room.hpp"
#include "driver/cli/read_plans.hpp"
#include "driver/plan/estimate/amounts.hpp"
#include "driver/plan/text.hpp"
#include "records/reference_store.hpp"
#include "support/in_shell.hpp"

namespace kreisel {

namespace {

struct PlannedConfig {
    Plan plan;
    std::filesystem::path folder;
};

std::vector<PlannedConfig> with_folders(std::vector<Plan> plans, const std::filesystem::path& output) {
    std::vector<PlannedConfig> result;
    const bool several = plans.size() > 1;
    for (Plan& plan : plans) {
        std::filesystem::path folder = output.empty() ? std::filesystem::path("results") / plan.config.name : output;
        if (several && !output.empty()) { folder /= plan.config.name; }
        for (const PlannedConfig& other : result) {
            if (other.folder == folder) {
                throw UsageError(
                    fmt::format("expected configs with different names, got {} twice", in_quotes(plan.config.name)));
            }
        }
        result.push_back({std::move(plan), std::move(folder)});
    }
    return result;
}

// The command that goes on with interrupted runs: the first of those that are left, and all after it.
std::string to_go_on(std::span<const PlannedConfig> left, std::span<const std::filesystem::path> configs,
                     const ConfigChanges& changes, const std::filesystem::path& output, const RunSettings& settings) {
    std::string command = "kreisel run";
    for (const auto& config : configs) { command += " " + in_shell(config.string()); }
    const std::filesystem::path folder = left.size() > 1 ? output : left.front().folder;  // several go to folders in it
    if (!folder.empty()) { command += " -o " + in_shell(folder.string()); }
    for (const std::string& setting : changes.settings) { command += " --set " + in_shell(setting); }
    for (const std::string& filter : changes.filters) { command += " --filter " + in_shell(filter); }
    if (settings.shards > 1) { command += fmt::format(" --shard {}/{}", settings.shard, settings.shards); }
    if (settings.timeout > 0) { command += fmt::format(" --timeout {}", settings.timeout); }
    if (settings.max_memory > 0) { command += fmt::format(" --max-memory {}", settings.max_memory); }
    if (!settings.references.empty()) { command += " --references " + in_shell(settings.references.string()); }
    if (settings.references_only) { command += " --references-only"; }
    return command + " --resume";
}

std::string what_was_done(const CampaignReport& report, bool references_only) {
    const CellCounts& counts = report.counts;
    if (references_only) {
        return fmt::format("{} references, {} failed", report.references, report.reference_failures.size());
    }
    std::string text = fmt::format("{} ok, {} skipped, {} failed", counts.ok, counts.skipped, counts.failed);
    if (report.reused > 0) { text += fmt::format(" ({} taken over from before)", report.reused); }
    return text;
}

Exit report(const CampaignReport& report, const PlannedConfig& planned, bool references_only,
            const std::string& to_go_on, std::ostream& messages) {
    for (const auto& [text, status] : report.failures) { fmt::print(messages, "failed: {}\n", text); }
    for (const std::string& text : report.reference_failures) { fmt::print(messages, "failed: {}\n", text); }
    for (const std::string& note : report.notes) { fmt::print(messages, "note: {}\n", note); }
    fmt::print(messages, "{}: {} in {}; results in {}\n", planned.plan.config.name,
               what_was_done(report, references_only), duration_text(report.seconds), planned.folder.string());
    if (report.interrupted) {
        for (const auto& part : report.parts) {
            fmt::print(messages, "samples of an unfinished cell: {}\n", part.string());
        }
        fmt::print(messages, "interrupted with {} cell{} to go; continue with: {}\n", report.counts.missing,
                   report.counts.missing == 1 ? "" : "s", to_go_on);
        return Exit::interrupted;
    }
    return report.counts.failed > 0 || !report.reference_failures.empty() ? Exit::cells_failed : Exit::ok;
}

// What long runs will take, and what there is no room for, before anything runs. Of a part, what all take together.
void say_before(const PlannedConfig& planned, const RunSettings& settings, std::ostream& messages) {
    constexpr double long_s = 60;
    const Estimate estimate = estimate_of(planned.plan);
    const std::string wanting = check_room(estimate, planned.folder, settings);
    if (estimate.seconds > long_s && settings.shards == 1) {
        fmt::print(messages, "{}: {}; {}\n", planned.plan.config.name, plan_summary(planned.plan),
                   estimate_text(estimate));
    }
    if (!wanting.empty()) { fmt::print(messages, "warning: {}\n", wanting); }
}

}  // namespace

Exit check_command(const Paths& written, const ConfigChanges& changes, const std::filesystem::path& references,
                   const Engines& engines, const Terminal& terminal) {
    const Paths configs = config_files(written);
    const auto plans = read_plans(configs, changes, references, engines, terminal.messages);
    for (std::size_t i = 0; i < plans.size(); ++i) {
        fmt::print(terminal.out, "{}: good; {}; {}\n", configs[i].string(), plan_summary(plans[i]),
                   estimate_text(estimate_of(plans[i])));
    }
    return Exit::ok;
}

Exit plan_command(const std::filesystem::path& config, const ConfigChanges& changes,
                  const std::filesystem::path& references, bool json, const Engines& engines,
                  const Terminal& terminal) {
    const Plan plan = read_plans(config_files({config}), changes, references, engines, terminal.messages).front();
    json ? print_plan_json(plan, terminal.out) : print_plan(plan, terminal.out);
    return Exit::ok;
}

Exit run_command(const Paths& written, const ConfigChanges& changes, const std::filesystem::path& output,
                 const RunSettings& given, const Engines& engines, const Terminal& terminal) {
    RunSettings settings = given;
    const Paths configs = config_files(written);
    if (settings.cache.empty()) { settings.cache = default_cache_folder(); }
    const auto all =
        with_folders(read_plans(configs, changes, settings.references, engines, terminal.messages), output);
    for (const PlannedConfig& planned : all) { check_output_folder(planned.folder, planned.plan, settings); }
    for (const PlannedConfig& planned : all) { say_before(planned, settings, terminal.messages); }
    const InterruptGuard guard;  // until the last word is said
    Exit result = Exit::ok;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const CampaignReport outcome = run_campaign(all[i].plan, engines, all[i].folder, settings, terminal.messages);
        const std::string command =
            to_go_on(std::span(all).subspan(i), std::span(configs).subspan(i), changes, output, given);
        const Exit one = report(outcome, all[i], settings.references_only, command, terminal.messages);
        if (one == Exit::interrupted) { return one; }
        result = one == Exit::ok ? result : one;
    }
    return result;
}

}  // namespace kreisel
