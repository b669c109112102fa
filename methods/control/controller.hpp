// SPDX-License-Identifier: BSD-3-Clause
//
// How the size of the next step follows from errors relative to the tolerance. With e_n of an accepted step, e_{n-1}
// and e_{n-2} of those before it, and an estimate O(h^r):
//   elementary   h+/h = S e_n^{-1/r}                                               [hairer1993, eq. II.4.13]
//   pi           h+/h = S e_n^{-0.7/r} e_{n-1}^{0.4/r}                             [gustafsson1991], [hairer1996]
//   pid          h+/h = S e_n^{-1/(4r)} e_{n-1}^{-1/(4r)} (h_n/h_{n-1})^{-1/4}     H211b with b = 4 [soderlind2003]
// S = 0.9, factors within [1/5, 5]. After a rejection the elementary law holds, and the next step does not grow.
#pragma once

#include <string>

#include "lie/real.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class StepSizeController {
  public:
    /// Throws std::invalid_argument for an unknown name.
    StepSizeController(const std::string& name, int estimate);

    /// Forgets the steps before.
    void start() { known_ = 0, rejected_ = false; }
    /// The factor for the next step after an accepted one by h with this error (relative, not above 1).
    Real after_acceptance(const Real& h, const Real& error);
    /// The factor, below 1, after a rejection; `error` is not finite where the attempt ended in a status.
    Real after_rejection(const Real& error);

  private:
    enum class Law { elementary, pi, pid };
    static Law law_of(const std::string& name);
    Real elementary(const Real& error) const;
    Real factor(const Real& h, const Real& error) const;

    Law law_;
    Real r_;
    int known_ = 0;  // accepted steps remembered
    bool rejected_ = false;
    Real error_before_ = 1, h_before_ = 1;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
