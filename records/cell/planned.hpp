// SPDX-License-Identifier: BSD-3-Clause
//
// What a record is about: one cell of an experiment, and the reference solution that cells are compared with.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/engine.hpp"
#include "records/cell/record.hpp"
#include "records/cell/series.hpp"
#include "support/hash.hpp"

namespace kreisel {

/// What cells that differ in their steps, or in the values of parameters of one entry, have in common, so that a plan
/// of many cells stays small.
struct PlannedRun {
    std::shared_ptr<const ProblemSeries> problems;
    std::shared_ptr<const SystemSummary> system;  ///< of these in this formulation
    Cell cell;                                    ///< but for its parameters and steps
    CellIdentity identity;                        ///< what results say of it; but for hash, label, parameters and steps
    std::string skip_reason;                      ///< not empty: the cells do not apply, and why
    std::string reference;  ///< name of the reference solution they are compared with; empty: none
};

struct PlannedCell {
    std::shared_ptr<const PlannedRun> run;
    std::size_t point = 0;   ///< which of the problems of the run
    std::uint64_t name = 0;  ///< a hash over all that determines the numbers
    long steps = 0;          ///< of one size; 0 where there is a tolerance
    double tolerance = 0;
    double weight = 0;  ///< estimated CPU time, s: long cells start first, parts of a run cost alike

    Cell cell() const;
    /// What its result says of it.
    CellIdentity identity() const;
    /// The name as 16 hexadecimal digits.
    std::string hash() const { return hash_text(name); }
    ProblemPoint problem() const { return {run->problems, point}; }
    const std::string& series() const { return run->problems->label(); }
    std::string label() const { return run->problems->label(point); }
    const std::string& precision() const { return run->identity.precision; }
    const std::string& skip_reason() const { return run->skip_reason; }
    const std::string& reference() const { return run->reference; }
    bool quad() const { return run->identity.quad(); }
};

/// A reference solution that cells are compared with.
struct PlannedReference {
    std::string problem;
    ParameterValues parameters;
    double t_end = 0;
    long samples = 0;                              ///< at which errors are wanted too
    std::string content;                           ///< all that determines its numbers, as JSON
    double weight = 0;                             ///< estimated CPU time, s
    std::shared_ptr<const BeginState> begin = {};  ///< null: the start of the problem
};

}  // namespace kreisel
