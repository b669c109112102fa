// SPDX-License-Identifier: BSD-3-Clause
//
// One step of a declared scheme for scripted accelerations, evaluated with dense matrices from the scheme only.
#pragma once

#include <functional>
#include <vector>

#include "methods/contract/description.hpp"
#include "methods/tableaus/bound_tableau.hpp"
#include "tests/judges/steps/dense.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct DensePoint {
    Real t;
    MatX q;
    VecX v;
};

/// The points at which the slopes are taken, in their order, the result, and the estimate of its error, (dq, dv); empty
/// where the scheme has none.
struct DenseStep {
    std::vector<DensePoint> stages;
    DensePoint result;
    VecX error;
};

/// A step to evaluate: the i-th stage finds the i-th acceleration of the script, whatever its state.
struct ScriptedStep {
    MatrixGroup group;
    Real h;
    DensePoint start;
    std::vector<VecX> script;
    OptionValues options;
    int order;  ///< declared, of the configuration
};

/// sum_j weights_j vectors_j, over as many as there are weights.
inline VecX combination(const std::vector<Coefficient>& weights, const std::vector<VecX>& vectors, Eigen::Index size) {
    VecX sum = VecX::Zero(size);
    for (std::size_t j = 0; j < weights.size(); ++j) sum += value(weights[j]) * vectors.at(j);
    return sum;
}

inline VecX joined(const VecX& a, const VecX& b) {
    VecX both(a.size() + b.size());
    both << a, b;
    return both;
}

/// An explicit tableau: `move(weights)` is the configuration that the slopes so far lead to, `slope(row, v)` is given
/// each new stage velocity. Velocities are additive.
template <class Move, class Slope>
DenseStep tableau_step(const Tableau& tableau, const ScriptedStep& given, Move move, Slope slope) {
    const DensePoint& start = given.start;
    const auto point = [&](const Real& c, const std::vector<Coefficient>& weights) -> DensePoint {
        const VecX dv = combination(weights, given.script, start.v.size());
        return {start.t + c * given.h, move(weights), start.v + given.h * dv};
    };
    DenseStep step;
    for (const auto& row : tableau.a) {
        Real c = 0;
        for (const auto& entry : row) c += value(entry);
        step.stages.push_back(point(c, row));
        slope(row, step.stages.back().v);
    }
    step.result = point(1, tableau.b);
    return step;
}

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
