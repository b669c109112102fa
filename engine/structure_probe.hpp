// SPDX-License-Identifier: BSD-3-Clause
//
// Measures the geometry of the steps of a cell: of one from the start and of one from the end, by a method of its own
// that starts afresh, so that the run does not notice.
#pragma once

#include "engine/engine.hpp"
#include "engine/observers/structure_metrics.hpp"
#include "methods/simulation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class StructureProbe {
  public:
    StructureProbe(const Cell& cell, const Setup& setup);
    StructureProbe(const StructureProbe&) = delete;
    StructureProbe& operator=(const StructureProbe&) = delete;

    /// From the state y at the time t.
    void observe(const Real& t, const std::vector<Real>& y);
    void report(Outcome& outcome) const { metrics_.report(outcome.metrics, outcome.unmeasured); }
    /// Solves of the dynamics so far.
    long evaluations() const { return simulation_.system().evaluations(); }

    /// Whether a cell asks for such metrics.
    static bool is_wanted(const Cell& cell) { return !StructureMetrics(cell.metrics).idle(); }

  private:
    StructureMetrics metrics_;
    Simulation simulation_;
    Step step_;
    std::vector<Real> state_ = simulation_.state();
    Real h_ = 0;  // 0: nothing can be measured
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
