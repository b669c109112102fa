// SPDX-License-Identifier: BSD-3-Clause
//
// The samples of a run: the bodies, angles of torsion springs, joint forces, and the metrics of the steps.
#pragma once

#include <string>
#include <vector>

#include "engine/observers/integral_metrics.hpp"
#include "engine/observers/step_metrics.hpp"
#include "engine/report/joint_forces.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// What a sample is taken from.
struct Sampled {
    const Model& model;
    JointForces& joint_forces;
    const StepMetrics& step_metrics;
    const IntegralMetrics& integral_metrics;
};

class Samples {
  public:
    /// Writes the columns. `every`: steps from one sample to the next; `sink` may be null.
    Samples(Sampled sources, long every, SampleSink* sink);
    /// Takes a sample after this step, if it is one of those. `multipliers`: the method's own, or null.
    void observe(long step, Observation& now, const Real* multipliers) {
        if (step % every_ == 0) take(now, multipliers);
    }

  private:
    void take(Observation& now, const Real* multipliers);
    std::vector<Column> columns() const;

    Sampled sources_;
    long every_;
    SampleSink* sink_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
