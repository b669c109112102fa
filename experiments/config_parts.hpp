// SPDX-License-Identifier: BSD-3-Clause
//
// The parts of a config: parameters of problems, options of methods, the time grid. Internal to the reader.
#pragma once

#include <string>
#include <vector>

#include "experiments/config.hpp"
#include "experiments/node.hpp"

namespace kreisel {

/// What a parameter of this kind is written as, in words.
std::string expectation(ParameterKind kind);

/// One combination of listed parameters.
struct ParameterPoint {
    ParameterValues values;  ///< complete
    std::string listed;      ///< ", links = 8": the values of the parameters that vary
};

/// Fills in what `written` (an object) gives; what it does not give keeps its default. A number given as a list is an
/// axis: all combinations, the last parameter of the description varying fastest.
std::vector<ParameterPoint> read_parameters(const Node& written, const ProblemDescription& problem);

/// Vectors, matrices row by row, and inertias (three numbers or a symmetric matrix).
std::optional<Vector3> read_vector(const Node& node, const std::string& expected);
std::optional<Matrix3> read_matrix(const Node& node, const std::string& expected);
std::optional<Matrix3> read_inertia(const Node& node);

/// Lists of bodies, joints and forces; the types and keys are those of experiments/model_keys.hpp.
std::optional<ParameterValue> read_bodies(const Node& node);
std::optional<ParameterValue> read_joints(const Node& node);
std::optional<ParameterValue> read_forces(const Node& node);

/// The values an option takes, in words; `expectation` names the option too.
std::string allowed_values(const OptionDescription& option);
std::string expectation(const OptionDescription& option);

/// All combinations of the options written beside "name" in `written` (an object), an option given as a list being an
/// axis; the last option of the description varies fastest.
std::vector<OptionValues> read_options(const Node& written, const std::vector<OptionDescription>& options);
std::vector<OptionValues> default_options(const std::vector<OptionDescription>& options);

/// Reads "time" into t_end and steps.
void read_time(const Node& time, Config& config);

}  // namespace kreisel
