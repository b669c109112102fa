// SPDX-License-Identifier: BSD-3-Clause
//
// When the samples of a run are taken: after every so many steps of one size; of steps to a tolerance at their times,
// either between the ends of steps (methods/control/interpolant.hpp), or by steps that are cut short to end there.
#pragma once

#include <optional>
#include <vector>

#include "engine/observers/samples.hpp"
#include "methods/control/interpolant.hpp"
#include "methods/simulation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class Sampler {
  public:
    /// Refers to all of these; `sink` may be null. `interpolates`: samples may lie between steps to a tolerance.
    Sampler(const Cell& cell, Simulation& simulation, const Sampled& sources, bool interpolates, SampleSink* sink);

    /// The sample of the start.
    void begin(Observation& start);
    /// Where the next step to a tolerance has to end at the latest.
    Real limit() const { return interpolant_ ? t_end_ : next(); }
    /// Before a step.
    void remember();
    /// After it: the samples inside it, which enter no maximum. One that cannot be interpolated is left out.
    void between(Observation& now);
    /// After that, with `now` observed at the end of the step: its sample, if it is one.
    void at_end(long steps_done, Observation& now);

    /// Solves of the dynamics for samples between steps.
    long evaluations() const { return interpolant_ ? interpolant_->evaluations() : 0; }

  private:
    bool due(long steps_done) const;
    void take(Observation& now, const Real* multipliers) { samples_.take(now, multipliers), ++taken_; }
    /// Time of the next sample.
    Real next() const;

    const Cell& cell_;
    Simulation& simulation_;
    Sampled sources_;
    Samples samples_;
    std::optional<Interpolant> interpolant_;
    std::vector<Real> before_, inside_;  // the state before the step, and one inside it
    Real t_end_, t_before_ = 0;
    long taken_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
