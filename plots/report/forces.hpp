// SPDX-License-Identifier: BSD-3-Clause
//
// What acts on the bodies of a motion: joints and forces between bodies as few bytes, weights and loads as what they
// follow from.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "records/geometry.hpp"
#include "records/reading/trajectory_table.hpp"
#include "records/results.hpp"

namespace kreisel {

/// The upper half of a number of 32 bits, rounded to nearest: 8 bits of mantissa, enough for an arrow. NaN for what is
/// larger than 1e38 or not finite.
std::uint16_t half_of_float(double value);

/// How many bytes of the page the joints and forces between bodies of a trajectory take at one instant.
std::size_t bytes_of_forces(const TrajectoryTable& trajectory);

/// Of the links of which a trajectory holds what they exert, reactions of joints or forces, and that hold one of these
/// bodies, a list of {"link": which of the mechanism's, "F" (N), "tau" (N m), each where it is not always 0: on the
/// second body, space axes, "force" (N), "torque" (N m): what drives a joint}; each number a half_of_float,
/// little-endian, in base64, instant after instant.
std::string forces_json(const TrajectoryTable& trajectory, const Geometry& mechanism,
                        const std::vector<std::string>& bodies, const std::vector<std::size_t>& instants);

/// What acts besides, as far as the parameters of the problem tell: {"gravity": {"g", "amplitude", "frequency"},
/// "loads": [{"body", "force" (N), "torque" (N m), "point", "frame", "amplitude", "frequency"}]} for
/// g (1 + amplitude sin(frequency t)) and alike. Points of loads in body axes, from the mass centre (m), as the first
/// sample has them. Forces between bodies are those of forces_json.
std::string applied_json(const JsonValue& parameters, const TrajectoryTable& trajectory);

}  // namespace kreisel
