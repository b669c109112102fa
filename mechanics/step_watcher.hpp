// SPDX-License-Identifier: BSD-3-Clause
//
// Systems whose equations depend on the step size.
#pragma once

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A mark of systems, beside `System`: begin_step and end_step are to stand around each step, as with torsion springs.
class StepWatcher {
  public:
    virtual ~StepWatcher() = default;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
