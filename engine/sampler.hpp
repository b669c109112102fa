// SPDX-License-Identifier: BSD-3-Clause
//
// When the samples of a run are taken: after every so many steps of one size; of steps to a tolerance at their times,
// either within steps, by dense output of the method or from the ends of the step (methods/control/interpolant.hpp), or
// by steps that are cut short to end there.
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
    /// What makes samples within steps to a tolerance: nothing, the method's own dense output, the ends of the step.
    enum class Between { none, own, ends };
    /// Refers to all of these; `sink` may be null.
    Sampler(const Cell& cell, Simulation& simulation, const Sampled& sources, Between between, SampleSink* sink);

    /// The sample of the start.
    void begin(Observation& start);
    /// Where the next step to a tolerance has to end at the latest.
    Real limit() const { return between_ == Between::none ? next() : t_end_; }
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
    /// The state at t, within the step that ended last.
    void find_inside(const Real& t, const Real& h);
    void take(Observation& now, const Real* multipliers) { samples_.take(now, multipliers), ++taken_; }
    /// Time of the next sample.
    Real next() const;

    const Cell& cell_;
    Simulation& simulation_;
    Sampled sources_;
    Samples samples_;
    Between between_;
    std::optional<Interpolant> interpolant_;
    std::vector<Real> before_, inside_;  // the state before the step, and one inside it
    Real t_begin_, t_end_, t_before_ = 0;
    long taken_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
