// SPDX-License-Identifier: BSD-3-Clause
//
// What a record is about: one cell of an experiment, and the reference solution that cells are compared with.
#pragma once

#include <string>

#include "engine/engine.hpp"
#include "records/cell/record.hpp"

namespace kreisel {

struct PlannedCell {
    Cell cell;
    std::string series;
    std::string label;
    std::string precision;
    std::string hash;         ///< 16 hexadecimal digits over all that determines the numbers
    CellIdentity identity;    ///< what its result says of it
    std::string skip_reason;  ///< not empty: the cell does not apply, and why
    std::string reference;    ///< name of the reference solution it is compared with; empty: none
    double weight = 0;        ///< estimated CPU time, s: long cells start first, parts of a run cost alike
    bool quad() const { return precision == "quad"; }
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
