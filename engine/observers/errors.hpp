// SPDX-License-Identifier: BSD-3-Clause
//
// Distances of a run from its reference: at the end, and the largest over the samples.
#pragma once

#include <string>
#include <vector>

#include "engine/metrics/metric.hpp"
#include "engine/observers/measured.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A run at one time: bodies and multipliers, which are empty where they are not known.
struct RunState {
    const std::vector<BodyState>& bodies;
    const std::vector<Real>& multipliers;
};

/// Adds the requested error metrics of a run that has ended at t_end (s) in a state. Past the horizon of the reference,
/// a distance from it is meaningful only if far above the uncertainty: an error is then given above 100 times that.
void report_errors(const Reference& reference, double t_end, const RunState& end,
                   const std::vector<ConstraintRow>& rows, const std::vector<std::string>& patterns,
                   MeasuredMetrics& all);

/// The error metrics NAME.max. All samples of the reference count; where one was not taken, or an error not be measured
/// there, no maximum is known. Past the horizon, a maximum is given if it is above 100 times the largest uncertainty.
class SampleErrors {
  public:
    /// Refers to the reference. Only requested ones are computed.
    SampleErrors(const Reference& reference, std::vector<ConstraintRow> rows, const std::vector<std::string>& patterns);
    bool idle() const { return entries_.empty(); }
    /// The next sample; that of the start comes first, and has no error.
    void add(const RunState& sample);
    /// The next sample is not known.
    void leave_out() { ++taken_; }
    /// The errors of a sample, under the names of their metrics.
    void add_columns(std::vector<Column>& all) const;
    /// Those of the sample added last; NaN where an error is not known, as at the start.
    void append_values(std::vector<Real>& row) const;
    /// Adds the maxima of a run that has ended at t_end (s).
    void report(double t_end, MeasuredMetrics& all) const;

  private:
    struct Entry {
        const Metric* metric;
        Real worst = 0, last = 0;
    };
    const Reference& reference_;
    std::vector<ConstraintRow> rows_;
    std::vector<std::string> patterns_;
    std::vector<Entry> entries_;
    std::size_t taken_ = 0, compared_ = 0;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
