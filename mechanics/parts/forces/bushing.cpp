// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/parts/force_type.hpp"

namespace kreisel {

KREISEL_FORCE_KEYS({"bushing",
                    "-stiffness_i p_i - damping_i p_i' and the same of three angles q_i, between frames of two bodies "
                    "that coincide at the start",
                    {{"between", ValueKind::names, true},
                     {"point", ValueKind::vector, true},
                     {"axes", ValueKind::matrix, false},
                     {"stiffness", ValueKind::not_negatives, true},
                     {"torsional_stiffness", ValueKind::not_negatives, true},
                     {"damping", ValueKind::not_negatives, false},
                     {"torsional_damping", ValueKind::not_negatives, false}}},
                   {.place = 8, .rigid_only = true});

}  // namespace kreisel
