// SPDX-License-Identifier: BSD-3-Clause
//
// The samples of a run: the bodies, angles of torsion springs, joint forces, what springs and
// other forces exert between bodies, the metrics of the steps, and what these have taken.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/observers/errors.hpp"
#include "engine/observers/integral_metrics.hpp"
#include "engine/observers/step_metrics.hpp"
#include "engine/report/exerted_forces.hpp"
#include "engine/report/joint_forces.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// What a sample is taken from.
struct Sampled {
    const Model& model;
    JointForces& joint_forces;
    StepMetrics& step_metrics;
    IntegralMetrics& integral_metrics;
    SampleErrors* errors;          ///< null without a reference
    std::function<Cost()> work{};  ///< what the steps have taken so far; null: samples do not tell
};

class Samples {
  public:
    /// Writes the columns; `sink` may be null.
    Samples(Sampled sources, SampleSink* sink);
    /// Takes a sample. `multipliers`: the method's own, or null. The metrics are those that were observed last.
    void take(Observation& now, const Real* multipliers);
    /// One that could not be interpolated.
    void leave_out() {
        if (sources_.errors) sources_.errors->leave_out();
    }

  private:
    std::vector<Column> columns() const;

    Sampled sources_;
    ExertedForces exerted_;
    SampleSink* sink_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
