// SPDX-License-Identifier: BSD-3-Clause
//
// The hash of a cell, and what its result says of it.
#pragma once

#include "records/cell/planned.hpp"

namespace kreisel {

/// Sets hash and identity of a cell whose other members are known. Labels do not count in the hash.
void identify(PlannedCell& planned, const Order& order);

}  // namespace kreisel
