// SPDX-License-Identifier: BSD-3-Clause
//
// The metrics invariant.NAME of first integrals, which a system names itself. Only requested ones are computed.
#pragma once

#include <string>
#include <vector>

#include "engine/metrics/observation.hpp"
#include "engine/observers/line_fit.hpp"
#include "engine/observers/measured.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class IntegralMetrics {
  public:
    IntegralMetrics(System& system, const std::vector<std::string>& patterns);
    bool idle() const { return entries_.empty(); }
    /// The first call fixes the initial values.
    void observe(Observation& now);
    /// Of a later state that is not the end of a step, for its sample: it enters neither maximum nor slope.
    void look(Observation& now);
    /// Adds the requested values to `all`. Of an unfinished run only the maxima, which hold for the part that was run:
    /// there is no final value, and slopes over different spans are not comparable.
    void report(bool finished, MeasuredMetrics& all) const;
    /// Columns and current values for a trajectory: each deviation and its running maximum.
    void add_columns(std::vector<Column>& all) const;
    void append_values(std::vector<Real>& row) const;

  private:
    struct Entry {
        const FirstIntegral* source;
        std::string name;
        Real start = 0, now = 0, worst = 0;
        bool has_relative = false;
        LineFit fit = {};
    };
    void begin(const MotionState& state);

    std::vector<std::string> patterns_;
    std::vector<Entry> entries_;
    bool started_ = false;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
