// SPDX-License-Identifier: BSD-3-Clause
//
// The fake engine, for a test that overrides a part of it.
#pragma once

#include "tests/driver/fake_engine.hpp"

namespace kreisel {

class OtherEngine : public Engine {
  public:
    std::vector<ProblemDescription> problems() const override { return fake_.problems(); }
    std::vector<MethodDescription> methods() const override { return fake_.methods(); }
    std::vector<ProjectionDescription> projections() const override { return fake_.projections(); }
    std::vector<FormulationDescription> formulations() const override { return fake_.formulations(); }
    std::vector<MetricDescription> metrics() const override { return fake_.metrics(); }
    SystemSummary summary(const std::string& problem, const ParameterValues& values,
                          const std::string& formulation) const override {
        return fake_.summary(problem, values, formulation);
    }
    Geometry geometry(const std::string& problem, const ParameterValues& values) const override {
        return fake_.geometry(problem, values);
    }
    MethodDescription method(const std::string& name, const OptionValues& options) const override {
        return fake_.method(name, options);
    }
    std::vector<SchemeRow> scheme(const std::string& method) const override { return fake_.scheme(method); }
    RotationStability stability(const std::string& method) const override { return fake_.stability(method); }
    std::string skip_reason(const Cell& cell) const override { return fake_.skip_reason(cell); }
    Outcome run(const Cell& cell, const Reference* reference, const Watch& watch, SampleSink* samples) const override {
        return fake_.run(cell, reference, watch, samples);
    }
    std::optional<double> run_time(const Cell& cell, const Watch& watch) const override {
        return fake_.run_time(cell, watch);
    }
    using Engine::reference;
    Reference reference(const std::string& problem, const ParameterValues& values, const BeginState* begin,
                        double t_end, long samples, const Watch& watch) const override {
        return fake_.reference(problem, values, begin, t_end, samples, watch);
    }
    using Engine::check_reference;
    ReferenceCheck check_reference(const std::string& problem, const ParameterValues& values, const BeginState* begin,
                                   const Reference& reference) const override {
        return fake_.check_reference(problem, values, begin, reference);
    }
    Linearisation linearise(const std::string& problem, const ParameterValues& values, const std::string& formulation,
                            const BeginState* begin) const override {
        return fake_.linearise(problem, values, formulation, begin);
    }
    BeginCheck check_begin(const std::string& problem, const ParameterValues& values, const std::string& formulation,
                           const BeginState& begin) const override {
        return fake_.check_begin(problem, values, formulation, begin);
    }
    std::string reference_digest() const override { return fake_.reference_digest(); }

  private:
    FakeEngine fake_;
};

}  // namespace kreisel
