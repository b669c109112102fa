// SPDX-License-Identifier: BSD-3-Clause
//
// The shape of a problem with parameters in a config: numbers, tensors, and lists of bodies, joints and forces, whose
// keys are those that each type of them declares.
#pragma once

#include "driver/config/schema/terms.hpp"
#include "problems/description.hpp"

namespace kreisel::schema {

Schema problem_object(const ProblemDescription& problem);

}  // namespace kreisel::schema
