// SPDX-License-Identifier: BSD-3-Clause
//
// How a force is made of what a user writes: a function that gets a checked entry, registered under the name by which
// its keys are in mechanics/parts/forces/.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/model/motion.hpp"
#include "support/registered.hpp"
#include "support/registration.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct Forces;

/// An entry of a list of forces, read for the keys of its type (problems/reading/forces.cpp): bodies by their number,
/// points and axes in the axes of their body, numbers checked. What the type has no key for has no meaning.
struct ForceEntry {
    int first = ground, second = ground;                                 ///< "between"; "body" is the second
    Vec3 r_first = Vec3::Zero(), r_second = Vec3::Zero();                ///< "points"
    Real distance = 0;                                                   ///< of the points at the start (m)
    Mat3 axes_first = Mat3::Identity(), axes_second = Mat3::Identity();  ///< "axis": their third; "axes"
    Real stiffness = 0, damping = 0;
    std::optional<Real> rest = {};  ///< "length" or "angle"
    long turns = 0;
    std::vector<Real> coefficients = {};
    /// Along axes and about them.
    std::array<Vec3, 2> stiffnesses = {Vec3::Zero(), Vec3::Zero()}, dampings = {Vec3::Zero(), Vec3::Zero()};
    Real attraction = 0;                   ///< "constant" or "mu"
    Real mass_first = 0, mass_second = 0;  ///< kg; of the ground 0
    Vec3 value = Vec3::Zero();
    Vec3 point = Vec3::Zero();  ///< on the body
    bool body_axes = false;     ///< "frame"
    Real amplitude = 0, frequency = 0;

    std::string path = {}, who = {};
    /// Throws ParameterError at the key: "force 0 (ground - wheel, spring): `what`".
    [[noreturn]] void refuse(const std::string& key, const std::string& what) const;
};

/// Adds the force to its list, or refuses the entry.
struct ForceReader {
    std::string name;
    void (*read)(const ForceEntry& entry, Forces& forces);
};

struct ForceReaderRegistration {
    ForceReaderRegistration(const char* name, void (*read)(const ForceEntry&, Forces&)) {
        Registered<ForceReader>::add({name, read});
    }
};

/// KREISEL_FORCE(name, function) in its file.
#define KREISEL_FORCE(...) KREISEL_REGISTER(ForceReaderRegistration, __VA_ARGS__)

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
