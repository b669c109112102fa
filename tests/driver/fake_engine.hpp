// SPDX-License-Identifier: BSD-3-Clause
//
// A small deterministic engine: enough problems, methods and options to exercise the driver, and methods that
// misbehave.
#pragma once

#include "engine/engine.hpp"
#include "tests/driver/workers/shared_count.hpp"

namespace kreisel {

/// Methods: rkmk/rk4 and rkmk/midpoint (options coordinates, dexpinv), baseline/rk4_quaternion (a flag; skipped on
/// SE3), fake/relaxed (a real option), fake/nan (fails half way), fake/infinite (reports an infinite metric), fake/slow
/// (one millisecond per step, checks stop requests, samples and tells its share on the way), fake/deaf (as slow, but
/// ignores stop requests and tells nothing), fake/throws, fake/throws_int, fake/pair (has an estimate of its error,
/// which is the tolerance), fake/own (chooses its steps itself), fake/tableau (options that are texts; one of them
/// decides its order).
class FakeEngine : public Engine {
  public:
    std::vector<ProblemDescription> problems() const override;
    std::vector<MethodDescription> methods() const override;
    std::vector<ProjectionDescription> projections() const override;
    std::vector<FormulationDescription> formulations() const override;
    std::vector<MetricDescription> metrics() const override;
    SystemSummary summary(const std::string& problem, const ParameterValues&,
                          const std::string& formulation) const override;
    /// Goes on from any state.
    BeginCheck check_begin(const std::string&, const ParameterValues&, const std::string&,
                           const BeginState&) const override {
        return {};
    }
    /// A body, "top", on a pin.
    Geometry geometry(const std::string& problem, const ParameterValues&) const override;
    MethodDescription method(const std::string& name, const OptionValues&) const override;
    /// Two rows of any method.
    std::vector<SchemeRow> scheme(const std::string&) const override { return {{"a_2", {"1/2"}}, {"b", {"0", "1"}}}; }
    /// That of the classical method; not defined of a method that chooses its steps.
    RotationStability stability(const std::string& method) const override;
    std::string skip_reason(const Cell&) const override;
    using Engine::run;
    Outcome run(const Cell&, const Reference* reference, const Watch&, SampleSink* samples) const override;
    std::optional<double> run_time(const Cell&, const Watch&) const override;
    using Engine::reference;
    /// Ends after t_end ms if t_end is above 1000 and no stop is requested.
    Reference reference(const std::string& problem, const ParameterValues&, const BeginState* begin, double t_end,
                        long samples, const Watch&) const override;
    using Engine::check_reference;
    ReferenceCheck check_reference(const std::string& problem, const ParameterValues&, const BeginState* begin,
                                   const Reference&) const override;
    /// An oscillator of frequency 1 on the first formulation, of multiplicity 2, which spins by 2 rad/s, or by the time
    /// of `begin`; refused where the mass is above 1000.
    Linearisation linearise(const std::string& problem, const ParameterValues&, const std::string& formulation,
                            const BeginState* begin) const override;
    std::string reference_digest() const override { return digest; }

    mutable SharedCount runs, references;
    mutable SharedNumbers timed;  ///< the steps of the cells that were timed further, in their order
    std::string digest = "fake";
};

}  // namespace kreisel
