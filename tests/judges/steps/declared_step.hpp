// SPDX-License-Identifier: BSD-3-Clause
//
// One step of a declared scheme for scripted accelerations, evaluated with dense matrices from the tableau only.
#pragma once

#include <vector>

#include "methods/contract/method.hpp"
#include "tests/judges/steps/dense.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

struct DensePoint {
    Real t;
    MatX q;
    VecX v;
};

/// The points at which the slopes are taken, in their order, and the result.
struct DenseStep {
    std::vector<DensePoint> stages;
    DensePoint result;
};

/// A chart as dense maps: psi(u), and u' for q = q0 psi(u), q' = q hat(v).
struct DenseChart {
    std::function<MatX(const VecX&)> psi;
    std::function<VecX(const VecX&, const VecX&)> pull_back;
};

/// The chart given by the options of a Munthe-Kaas method; no options mean exp, with dexpinv in full.
DenseChart dense_chart(const MatrixGroup& group, const OptionValues& options, int order);

/// y_{n+1} = y_n psi(h sum b_j k~_j), see methods/rkmk/rkmk.hpp.
DenseStep dense_munthe_kaas(const MatrixGroup& group, const DenseChart& chart, const Tableau& tableau,
                            const std::vector<VecX>& script, const Real& h, const DensePoint& start);
/// y_{n+1} = y_n exp(h b_1 K_1) ... exp(h b_s K_s), see methods/crouch_grossman/crouch_grossman.hpp.
DenseStep dense_crouch_grossman(const MatrixGroup& group, const Tableau& tableau, const std::vector<VecX>& script,
                                const Real& h, const DensePoint& start);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
