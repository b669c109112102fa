// SPDX-License-Identifier: BSD-3-Clause
//
// Kinds of experiments: a file of this folder for each, which registers itself. Whatever depends on the kind is stated
// there: for the reader of configs and the plan, for the campaign, and for tables and figures, which know the kind
// from the manifest. All of them see this room.
#pragma once

#include <string>
#include <vector>

#include "support/registration.hpp"

namespace kreisel {

/// What a config asks for, as far as its kind has a say in it.
struct ExperimentRequest {
    std::vector<std::string> metrics;
    long samples = 0;
};

using Advice = std::vector<std::string>;

struct ExperimentKind {
    std::string name;
    std::string summary;
    std::vector<std::string> metrics;  ///< names and patterns that are measured unless the config has "metrics"
    /// Cells measure the time and memory of their steps. They run one at a time, and measure and store nothing else.
    bool timed = false;
    /// Cells are run again, without measuring, for the CPU time of their steps. They run one at a time, in turns.
    bool repeated = false;
    std::string figure;  ///< the kind of figure that is drawn unless the config has "figure"
    /// Warnings about a config that can run, but hardly does what is wanted.
    Advice (*advise)(const ExperimentRequest& request) = [](const ExperimentRequest& /*request*/) { return Advice(); };
};

/// All of them, by name.
const std::vector<ExperimentKind>& experiment_kinds();
/// Null where there is none of that name.
const ExperimentKind* find_experiment_kind(const std::string& name);

/// Records a kind; a static object of this type is what KREISEL_EXPERIMENT declares.
struct ExperimentRegistration {
    explicit ExperimentRegistration(ExperimentKind kind);
};

}  // namespace kreisel

/// KREISEL_EXPERIMENT({.name = "drift", .summary = "...", .metrics = {"defect.*"}, .figure = "drift"}).
#define KREISEL_EXPERIMENT(...) KREISEL_REGISTER(::kreisel::ExperimentRegistration, __VA_ARGS__)
