// SPDX-License-Identifier: BSD-3-Clause
//
// The description of a method, free of `Real`: the driver lists, checks and documents methods from this alone.
#pragma once

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "methods/contract/claims.hpp"

namespace kreisel {

/// The value of an option as a config writes it: a word, a count, a flag or a real.
using OptionValue = std::variant<std::string, long, bool, double>;
using OptionValues = std::map<std::string, OptionValue>;

/// What an option takes as a text that is not one of its choices.
enum class OptionText {
    none,
    numbers,  ///< exact ones, apart by blanks: "1/6 0.25 -1"; a config may give them as a list
    rows,     ///< of such numbers, apart by semicolons: "1/2; 0 1/2"; likewise as a list of lists
    label,    ///< any text, or none; it names what the other options make
};

/// An option: which values it takes and its default.
/// A word must be one of `choices`; a count must lie in [count_min, count_max] (none where count_max < count_min);
/// a flag is allowed where the default is a flag; a real must lie in [real_min, real_max]; a text is as `text` says.
struct OptionDescription {
    std::string name;
    std::string summary;
    OptionValue standard;
    std::vector<std::string> choices = {};
    long count_min = 0, count_max = -1;
    double real_min = 0, real_max = -1;
    OptionText text = OptionText::none;
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

/// How the stages of a step are found: each in closed form from those before; each with multipliers that are solved
/// for; or all together, by iteration.
enum class Form { explicit_steps, half_explicit, implicit };

struct MethodDescription {
    std::string name;  ///< family/scheme
    Order order;
    std::vector<std::string> cites;  ///< keys of paper/references.bib
    std::string summary = {};
    /// What steps cost. `stages`: solves of the dynamics per step; of an implicit method, its implicit stages, if it
    /// has such. Where not `variable_cost`, these are the counts, to the last solve.
    int stages = 0;
    int solves_at_start = 0;     ///< before the first step
    int force_evaluations = 0;   ///< per step, of forces without a solve
    bool variable_cost = false;  ///< counts depend on the motion: iterations, order and step chosen
    /// r, where an attempt at a step estimates its error by some e = O(h^r) (Integrator::attempt): p with local
    /// extrapolation, which advances the more accurate of two solutions, else p + 1. 0: there is no estimate.
    int estimate = 0;
    /// The order of its own dense output (Integrator::interpolate) in steps to a tolerance. 0: there is none, and
    /// states within steps are interpolated from their ends (methods/control/interpolant.hpp).
    int dense = 0;
    /// Chooses its steps by a control of its own (Factory::stepper), to a tolerance only; constant steps do not apply.
    bool own_control = false;
    /// A projection may follow each step. False of multistep methods of other libraries, which would have to forget at
    /// every step what they remember.
    bool projectable = true;
    Form form = Form::explicit_steps;
    bool reports_multipliers = false;  ///< of its own (Integrator::multipliers); else they follow from the index-1 form
    /// The levels of the constraints that hold after a step without a projection, Phi = 0 and C v + b = 0.
    bool meets_positions = false, meets_velocities = false;
    bool keeps_memory = false;  ///< a step uses what earlier ones left; Integrator::start makes it forget
    std::vector<Claim> preserves = {};
    /// Commutes with rigid motions of space, to round-off, as every method formulated on the group does. False if
    /// coordinates prefer directions of space.
    bool equivariant = true;
    std::vector<OptionDescription> options = {};
    std::vector<std::string> formulations = {};  ///< formulations where it applies; empty: all

    bool is_implicit() const { return form == Form::implicit; }
    bool meets_constraints() const { return meets_positions && meets_velocities; }
    /// Whether it declares the property for all systems of the domain.
    bool claims(Property property, Domain domain = Domain::free) const {
        return std::any_of(preserves.begin(), preserves.end(),
                           [&](const Claim& claim) { return claim.property == property && claim.domain >= domain; });
    }
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
