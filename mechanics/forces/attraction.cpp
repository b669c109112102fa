// SPDX-License-Identifier: BSD-3-Clause
#include "mechanics/forces/attraction.hpp"

#include "mechanics/forces/entry.hpp"
#include "mechanics/forces/forces.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

namespace {

void read_gravitation(const ForceEntry& entry, Forces& forces) {
    if (entry.first == ground || entry.second == ground)
        entry.refuse("between", "expected two bodies that move: the ground has no mass; a centre has a central_field");
    if (entry.distance == 0) entry.refuse("between", "expected bodies whose mass centres differ at the start");
    forces.attractions.push_back({.first = entry.first,
                                  .second = entry.second,
                                  .strength = entry.attraction * entry.mass_first * entry.mass_second});
}

void read_central_field(const ForceEntry& entry, Forces& forces) {
    if (entry.distance == 0)
        entry.refuse("centre", "expected a point that is not the mass centre of the body at the start");
    forces.attractions.push_back(
        {.second = entry.second, .r_first = entry.r_first, .strength = entry.attraction * entry.mass_second});
}

}  // namespace

KREISEL_FORCE("gravitation", read_gravitation);
KREISEL_FORCE("central_field", read_central_field);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
