// SPDX-License-Identifier: BSD-3-Clause
//
// The description of a method, free of `Real`: the driver lists, checks and documents methods from this alone.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace kreisel {

/// The value of an option as a config writes it: a word, a count, a flag or a real.
using OptionValue = std::variant<std::string, long, bool, double>;
using OptionValues = std::map<std::string, OptionValue>;

/// An option: which values it takes and its default.
/// A word must be one of `choices`; a count must lie in [count_min, count_max] (none where count_max < count_min);
/// a flag is allowed where the default is a flag; a real must lie in [real_min, real_max].
struct OptionDescription {
    std::string name;
    std::string summary;
    OptionValue standard;
    std::vector<std::string> choices = {};
    long count_min = 0, count_max = -1;
    double real_min = 0, real_max = -1;
};

/// The declared order of a method, separately for configuration, velocity and multipliers: they differ in several
/// half-explicit and variational families.
struct Order {
    int configuration = 0, velocity = 0, multipliers = 0;
    constexpr Order() = default;
    constexpr Order(int p) : configuration(p), velocity(p), multipliers(p) {}  // NOLINT: allows `.order = 4`
    constexpr Order(int q, int v, int l) : configuration(q), velocity(v), multipliers(l) {}
    bool operator==(const Order&) const = default;
};

struct MethodDescription {
    std::string name;  ///< family/scheme
    Order order;
    std::vector<std::string> cites;  ///< keys of paper/references.bib
    std::string summary = {};
    int stages = 0;  ///< solves of the dynamics per step; of an implicit method, its implicit stages, if it has such
    /// r, where an attempt at a step estimates its error by some e = O(h^r) (Integrator::attempt): p with local
    /// extrapolation, which advances the more accurate of two solutions, else p + 1. 0: there is no estimate.
    int estimate = 0;
    /// Chooses its steps by a control of its own (Factory::stepper), to a tolerance only; constant steps do not apply.
    bool own_control = false;
    /// A projection may follow each step. False of multistep methods of other libraries, which would have to forget at
    /// every step what they remember.
    bool projectable = true;
    bool implicit = false;
    bool symmetric = false;
    /// Multipliers are unknowns of a step, which satisfies the constraints on positions and velocities by itself:
    /// nothing is left to project, and a projection would invalidate its memory.
    bool own_multipliers = false;
    /// Commutes with rigid motions of space, to round-off, as every method formulated on the group does. False if
    /// coordinates prefer directions of space.
    bool equivariant = true;
    std::vector<OptionDescription> options = {};
    std::vector<std::string> formulations = {};  ///< formulations where it applies; empty: all
};

struct ProjectionDescription {
    std::string name;
    std::string summary;
    std::vector<std::string> cites;
    std::vector<OptionDescription> options = {};
    std::vector<std::string> formulations = {};  ///< formulations where it applies; empty: all
    /// The levels of the constraints that hold after it, Phi = 0 and C v + b = 0.
    bool positions = false, velocities = false;
    /// Needs the rows in ambient coordinates (System::has_ambient_jacobian).
    bool ambient = false;
};

/// An option with a value it cannot take.
struct OptionError : std::invalid_argument {
    std::string option;
    OptionError(std::string name, const std::string& what) : std::invalid_argument(what), option(std::move(name)) {}
};

/// `given`, and the defaults of the options that it does not name. Throws OptionError for an unknown option.
inline OptionValues with_defaults(OptionValues given, const std::vector<OptionDescription>& options) {
    for (const OptionDescription& option : options) given.insert({option.name, option.standard});
    if (given.size() == options.size()) return given;
    for (const OptionDescription& option : options) given.erase(option.name);
    throw OptionError(given.begin()->first, "there is no option \"" + given.begin()->first + "\"");
}

}  // namespace kreisel
