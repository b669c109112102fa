// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "methods/contract/description.hpp"
#include "tests/judges/steps/dense.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A chart as dense maps: psi(u), and u' for q = q0 psi(u), q' = q hat(v).
struct DenseChart {
    std::function<MatX(const VecX&)> psi;
    std::function<VecX(const VecX&, const VecX&)> pull_back;
};

/// The chart given by the options of a Munthe-Kaas method of this order; no options mean exp, with dexpinv in full.
/// Throws std::out_of_range for coordinates it does not know.
DenseChart dense_chart(const MatrixGroup& group, const OptionValues& options, int order);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
