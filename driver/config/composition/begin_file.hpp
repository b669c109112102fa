// SPDX-License-Identifier: BSD-3-Clause
//
// A start from a sample of an earlier trajectory.
#pragma once

#include "records/json/diagnostics.hpp"

namespace kreisel {

/// Where "begin" of "time" has the key "file", the path of samples (results/NAME/trajectories/CELL.csv) relative to the
/// folder of the config that names it, the state of the sample at "t", or of the last, takes its place, with every
/// digit. Samples in a results folder are held against the sum of their cell. Throws UsageError; FileError on files
/// that cannot be read or are damaged.
void insert_begin_file(Document& config);

}  // namespace kreisel
