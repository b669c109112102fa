// SPDX-License-Identifier: BSD-3-Clause
//
// Whether a run conserves the first integrals of its system at all, independent of the metrics requested.
#pragma once

#include <optional>
#include <vector>

#include "engine/engine.hpp"
#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class Conservation {
  public:
    /// At the start y; refers to the system.
    Conservation(System& system, const Real* y);

    /// The integral that y violates most, by |I - I_0| over the larger sum of the sizes of its terms (dimensionless);
    /// nothing where that is at most 1/100 of each.
    std::optional<LostIntegral> lost(const Real* y);

  private:
    struct Value {
        Real now, size;
    };
    std::vector<Value> values(const Real* y);

    System& system_;
    std::vector<BodyState> states_;
    std::vector<SpringAngle> springs_;
    std::vector<Real> angles_;
    std::vector<Value> start_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
