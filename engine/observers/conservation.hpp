// SPDX-License-Identifier: BSD-3-Clause
//
// Whether a run conserves the first integrals of its system at all, independent of the metrics requested.
#pragma once

#include <optional>
#include <vector>

#include "engine/engine.hpp"
#include "engine/metrics/observation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class Conservation {
  public:
    /// At the start.
    explicit Conservation(Observation& start);

    /// The integral that a state violates most, by |I - I_0| over the larger sum of the sizes of its terms
    /// (dimensionless); nothing where that is at most 1/100 of each.
    std::optional<LostIntegral> lost(Observation& now) const;

  private:
    struct Value {
        Real now, size;
    };
    static std::vector<Value> values(Observation& now);

    std::vector<Value> start_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
