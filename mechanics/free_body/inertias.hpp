// SPDX-License-Identifier: BSD-3-Clause
//
// The moments of inertia of the bodies of a system without joints, for methods that treat each body by itself: blocks
// of its mass matrix, of bodies about fixed points (v = omega) or free in space (v = (x', omega), both in their own
// axes).
#pragma once

#include <string>
#include <vector>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class BodyInertias {
  public:
    explicit BodyInertias(const System& system);

    int bodies() const { return bodies_; }
    /// Whether x' comes before the omega of each body.
    bool in_space() const { return block_ > pivoted_; }
    /// Takes the inertias at q; returns whether any has changed since.
    bool weigh(const Real* q);
    /// About the fixed point or the mass centre, in body axes.
    Mat3 of(int body) const;

    /// Why the system is none of such bodies; empty if it is.
    static std::string why_not(const System& system);

  private:
    static constexpr int pivoted_ = 3, free_ = 6;

    const System& system_;
    int bodies_, block_;
    std::vector<Real> blocks_, known_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
