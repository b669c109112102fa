// SPDX-License-Identifier: BSD-3-Clause
//
// The metrics that are measured after every step. Only requested ones are computed.
#pragma once

#include <string>
#include <vector>

#include "engine/metrics/metric.hpp"
#include "engine/observers/measured.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class StepMetrics {
  public:
    /// Those of the system's kinds of rows that the patterns ask for.
    StepMetrics(System& system, const std::vector<std::string>& patterns);
    bool idle() const { return entries_.empty(); }
    void observe(Observation& now);
    /// Of a state that is not the end of a step, for its sample: it enters no maximum.
    void look(Observation& now);
    /// Adds the requested values to `all`. Of an unfinished run only the maxima, which hold for the part that was run,
    /// if they are finite. In a finished one a maximum that is not finite stands for a step that could not be measured.
    void report(bool finished, MeasuredMetrics& all) const;
    /// Columns and current values for a trajectory: each quantity and its running maximum.
    void add_columns(std::vector<Column>& all) const;
    void append_values(std::vector<Real>& row) const;

  private:
    struct Entry {
        const Metric* metric;
        Real now = 0, worst = 0;
    };
    std::vector<std::string> patterns_;
    std::vector<Entry> entries_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
