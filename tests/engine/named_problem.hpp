// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lie/so3.hpp"
#include "problems/problem.hpp"

namespace reference_tests {

/// An attitude in which no body axis is a space axis.
inline const kreisel::Mat3 oblique = kreisel::SO3::exp(kreisel::Vec3(2, -5, 3) / 5);

/// A problem with its default parameters, or its demonstration where it has no defaults.
inline kreisel::Model standard_model(const std::string& name) {
    const kreisel::Problem& problem = kreisel::problem(name);
    const kreisel::ParameterValues values = demonstration_parameters(problem.description);
    return problem.build(kreisel::Parameters(values));
}

}  // namespace reference_tests
