// SPDX-License-Identifier: BSD-3-Clause
//
// Parameters of problems from files of their own.
#pragma once

#include "records/json/diagnostics.hpp"

namespace kreisel {

/// Where the parameters of a problem have the key "file", the path of a file relative to the folder of the config that
/// names it, those that the file holds take its place; keys beside it change them (RFC 7396). The file is a JSON object
/// of parameters, or a robot in URDF, which "positions" and "rates" of its joints and "root" ("ground" or "free") put
/// in place. Messages about what it holds point into it. Throws UsageError; FileError on files that cannot be read.
void insert_mechanism_files(Document& config);

}  // namespace kreisel
