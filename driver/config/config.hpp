// SPDX-License-Identifier: BSD-3-Clause
//
// A config as read and resolved: every name known, every default filled in, every option list multiplied out.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "driver/config/catalogue.hpp"
#include "records/cell/series.hpp"

namespace kreisel {

struct Document;  // records/json/diagnostics.hpp
class Diagnostics;

/// A method or a projection with one value for each of its options.
struct OptionedEntry {
    std::string name;
    OptionValues options;  ///< complete
    std::string pointer;
};

struct Config {
    std::string name;
    std::string description;
    std::string kind;  ///< one of experiment_kinds()
    std::vector<std::string> precisions;
    std::vector<ProblemPoint> problems;  ///< those of one entry one after the other
    std::vector<std::string> formulations;
    std::vector<OptionedEntry> methods;
    std::vector<OptionedEntry> projections;
    std::shared_ptr<const BeginState> begin;  ///< null: the starts of the problems, at t = 0
    double t_end = 0;
    /// How long runs are, s.
    double duration() const { return t_end - (begin ? begin->t.value : 0); }
    std::vector<long> steps;         ///< of one size; empty where there are only tolerances
    std::vector<double> tolerances;  ///< to which methods choose their steps; may be empty
    std::string controller = "pi";   ///< of steps to a tolerance
    long samples = 0;
    bool dense = true;  ///< samples to a tolerance may fall between steps
    std::vector<std::string> metrics;
    bool metrics_given = false;  ///< false: the defaults of the kind apply
    std::string figure;          ///< as written, JSON; empty if absent
    std::vector<std::string> warnings;
    std::shared_ptr<const Config> whole;  ///< what --filter left a part of; null: this is all
    /// True if cells measure the time and memory of their steps, and nothing else.
    bool is_timed() const;
    /// True if cells are run again for the time of their steps.
    bool is_repeated() const;
    /// True if cells run one at a time, because times are measured.
    bool runs_alone() const { return is_timed() || is_repeated(); }
};

/// Reads a config. Throws UsageError with every error found; physical validity is checked when the plan is made.
Config read_config(const Document& document, const Catalogue& catalogue);

}  // namespace kreisel
