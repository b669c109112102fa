// SPDX-License-Identifier: BSD-3-Clause
//
// What a problem says of itself, free of `Real`: the driver lists, checks and documents problems from this alone.
#pragma once

#include <string>
#include <vector>

#include "mechanics/data.hpp"

namespace kreisel {

/// The kind decides what a config may write: `inertia` is three numbers or a symmetric 3x3 matrix, `rotation` a 3x3
/// matrix, `bodies`, `joints` and `forces` lists of objects, `flag` true or false; the alternative of ParameterValue
/// follows from it (inertia, rotation: Matrix3).
enum class ParameterKind { scalar, positive, vector, inertia, rotation, bodies, joints, forces, flag };

struct ParameterDescription {
    std::string name;
    ParameterKind kind = ParameterKind::scalar;
    std::string unit;
    std::string summary;
    ParameterValue standard;
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
};

struct ProblemDescription {
    std::string name;
    std::string summary;
    std::vector<std::string> cites;  ///< keys of paper/references.bib
    std::vector<ParameterDescription> parameters;
    bool closed_form = false;
};

}  // namespace kreisel
