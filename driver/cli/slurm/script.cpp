// SPDX-License-Identifier: BSD-3-Clause
#include "driver/cli/slurm/script.hpp"

#include <fmt/format.h>

#include "support/hash.hpp"
#include "support/in_shell.hpp"

namespace kreisel {

namespace build {
extern const char* const slurm_jobs;
}

namespace {

constexpr const char* sum_line = "\n# sum ";

std::string words_in_shell(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) { text += (text.empty() ? "" : " ") + in_shell(word); }
    return text;
}

std::string config_line(const std::string& config) { return fmt::format("\n# config.json {}\n", hash_text(config)); }

}  // namespace

std::string submit_script(const ClusterJob& job, const std::string& config) {
    std::string text =
        fmt::format(R"(#!/usr/bin/env bash
# Written by kreisel slurm: computes {} in {} on a Slurm cluster, and puts the results together.
#     bash submit.sh [SBATCH-OPTION...]
# submits it; the options are for all of its jobs. Submitted again, it goes on: what is done stays.
# What the jobs say is in slurm/.{}
name={}
kreisel={}
folder={}
parts={}
references={}
limits=({})
options=({})
)",
                    job.name, job.parts == 1 ? "one part" : fmt::format("{} parts", job.parts), config_line(config),
                    job.name, in_shell(job.program.string()), in_shell(job.folder.string()), job.parts, job.references,
                    words_in_shell(job.limits), words_in_shell(job.options));
    text += build::slurm_jobs;
    return text + sum_line + hash_text(text) + "\n";
}

bool is_submit_script(const std::string& text) {
    const auto sum = text.rfind(sum_line);
    return sum != std::string::npos && text.substr(sum) == sum_line + hash_text(text.substr(0, sum)) + "\n";
}

bool is_script_of(const std::string& script, const std::string& config) {
    return script.find(config_line(config)) != std::string::npos;
}

}  // namespace kreisel
