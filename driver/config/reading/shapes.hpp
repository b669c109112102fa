// SPDX-License-Identifier: BSD-3-Clause
//
// How the shapes of bodies are read. Internal to the reader.
#pragma once

#include "problems/description.hpp"
#include "records/json/model.hpp"
#include "records/json/node.hpp"

namespace kreisel {

/// Those of all bodies that the parameters of a problem describe, those on an axis too: bodies of one name have one
/// shape.
Shapes read_shapes(const Node& parameters, const ProblemDescription& problem);

}  // namespace kreisel
