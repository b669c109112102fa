// SPDX-License-Identifier: BSD-3-Clause
//
// The metrics structure.NAME of single steps. Only requested ones are computed.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/metrics/metric.hpp"
#include "engine/observers/measured.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class StructureMetrics {
  public:
    explicit StructureMetrics(const std::vector<std::string>& patterns);
    bool idle() const { return entries_.empty(); }
    /// Measures the step; the larger of several counts.
    void observe(const ObservedStep& at);
    /// Nothing can be measured of these steps, for this reason.
    void decline(const std::string& why_not);
    /// Adds the requested values to `all`, those above ten times their uncertainty, and each uncertainty; to
    /// `unmeasured` the metrics of which nothing is known, and why.
    void report(MeasuredMetrics& all, std::map<std::string, std::string>& unmeasured) const;

  private:
    struct Entry {
        const Metric* metric;
        StepDefect worst;
    };
    std::vector<std::string> patterns_;
    std::vector<Entry> entries_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
