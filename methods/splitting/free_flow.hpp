// SPDX-License-Identifier: BSD-3-Clause
//
// The exact motion of the bodies of a system on which nothing acts, about fixed points or free in space.
#pragma once

#include <vector>

#include "mechanics/free_body/free_rotation.hpp"
#include "mechanics/free_body/inertias.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class FreeFlow {
  public:
    explicit FreeFlow(const System& system);
    /// Takes the inertias at q, which may have changed.
    void weigh(const Real* q);
    /// (q, v) -> their values after the time t, in place.
    void advance(const Real& t, Real* q, Real* v);

  private:
    const Group& group_;
    BodyInertias inertias_;
    struct Spinning {
        FreeRotor rotor;
        Mat3 J, J_inverse;
    };
    std::vector<Spinning> bodies_;
    std::vector<Real> u_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
