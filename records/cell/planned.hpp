// SPDX-License-Identifier: BSD-3-Clause
//
// What a record is about: one cell of an experiment, and the reference solution that cells are compared with.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/engine.hpp"
#include "records/cell/record.hpp"
#include "support/hash.hpp"

namespace kreisel {

/// What cells that differ in their steps only have in common, so that a plan of many cells stays small.
struct PlannedRun {
    Cell cell;                ///< but for its steps
    CellIdentity identity;    ///< what results say of it; but for hash and steps
    std::string skip_reason;  ///< not empty: the cells do not apply, and why
    std::string reference;    ///< name of the reference solution they are compared with; empty: none
};

struct PlannedCell {
    std::shared_ptr<const PlannedRun> run;
    std::uint64_t name = 0;  ///< a hash over all that determines the numbers
    long steps = 0;          ///< of one size; 0 where there is a tolerance
    double tolerance = 0;
    double weight = 0;  ///< estimated CPU time, s: long cells start first, parts of a run cost alike

    Cell cell() const;
    /// What its result says of it.
    CellIdentity identity() const;
    /// The name as 16 hexadecimal digits.
    std::string hash() const { return hash_text(name); }
    const std::string& series() const { return run->identity.series; }
    const std::string& label() const { return run->identity.label; }
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
    long samples = 0;     ///< at which errors are wanted too
    std::string content;  ///< all that determines its numbers, as JSON
    double weight = 0;    ///< estimated CPU time, s
};

}  // namespace kreisel
