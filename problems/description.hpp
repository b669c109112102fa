// SPDX-License-Identifier: BSD-3-Clause
//
// The description of a problem, free of `Real`: the driver lists, checks and documents problems from this alone.
#pragma once

#include <string>
#include <vector>

#include "mechanics/model/data.hpp"

namespace kreisel {

/// Largest number of the kind `count`.
inline constexpr long largest_parameter_count = 1'000'000;

/// The kind decides what a config may write: `count` is a whole number from 1 to 1,000,000, `inertia` three numbers or
/// a symmetric 3x3 matrix, `rotation` a 3x3 matrix, `bodies`, `joints` and `forces` lists of objects, `flag` true or
/// false; the alternative of ParameterValue follows from it (scalar, positive, count: double; inertia, rotation:
/// Matrix3).
enum class ParameterKind { scalar, positive, count, vector, inertia, rotation, bodies, joints, forces, flag };

struct ParameterDescription {
    std::string name;
    ParameterKind kind = ParameterKind::scalar;
    std::string unit;
    std::string summary;
    ParameterValue standard;  ///< used if the config does not give it
    bool required = false;    ///< required in a config
};

/// A quantity the exact flow preserves, and the reason why it does.
struct IntegralDescription {
    std::string name;
    std::string unit;
    std::string reason;
};

struct FormulationDescription {
    std::string name;
    std::string summary;
    std::vector<std::string> cites = {};  ///< keys of paper/references.bib
};

struct ProblemDescription {
    std::string name;
    std::string summary;
    std::vector<std::string> cites;  ///< keys of paper/references.bib
    std::vector<ParameterDescription> parameters;
    bool closed_form = false;
    /// Where parameters are required: values for a demonstration, and the config in experiments/ that has them.
    ParameterValues demonstration = {};
    std::string demonstration_config = {};
};

/// The value used if a config does not give one.
inline ParameterValues default_parameters(const ProblemDescription& problem) {
    ParameterValues values;
    for (const ParameterDescription& parameter : problem.parameters) values[parameter.name] = parameter.standard;
    return values;
}

/// A complete instance of the problem: its demonstration, or all defaults.
inline ParameterValues demonstration_parameters(const ProblemDescription& problem) {
    ParameterValues values = default_parameters(problem);
    for (const auto& [name, value] : problem.demonstration) values[name] = value;
    return values;
}

/// The parameters that a config must give.
inline std::vector<std::string> required_parameters(const ProblemDescription& problem) {
    std::vector<std::string> names;
    for (const ParameterDescription& parameter : problem.parameters)
        if (parameter.required) names.push_back(parameter.name);
    return names;
}

}  // namespace kreisel
