// SPDX-License-Identifier: BSD-3-Clause
//
// The size of an error of a step relative to its tolerance. Each unknown is divided by tol times its scale: 1 rad for
// rotations, the length of the mechanism for positions (never |x|, which would depend on its place), and these times
// the rate of the motion for velocities; of these the root mean square is taken. So units, place and orientation change
// no step, and units that are powers of two no bit of one.
#pragma once

#include <vector>

#include "mechanics/system.hpp"
#include "methods/control/stepper.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class ErrorNorm {
  public:
    /// Sizes its work space. The system outlives this.
    ErrorNorm(const System& system, const Accuracy& accuracy);

    /// Root mean square over the algebra of TG of error_i / (tol s_i), for a step by h from y to y_new. Not finite
    /// where an entry is not.
    Real operator()(const Real& h, const Real* y, const Real* y_new, const Real* error) const;
    /// The same for the element of TG that leads from y to `moved`, log(y^{-1} moved).
    Real distance(const Real& h, const Real* y, const Real* moved);

    /// Rate of the motion (1/s): the largest of |omega| and |x'|/length over the bodies at both ends, and of the roots
    /// of their changes over h, because at a turning point the velocity says nothing.
    Real rate(const Real& h, const Real* y, const Real* y_new) const;
    /// The same at one state, from its slope z = (v, v').
    Real rate(const Real* z) const;

  private:
    bool is_translation(int triple) const { return triples_per_body_ == 2 && triple % 2 == 0; }
    Real weight(int triple) const { return is_translation(triple) ? inverse_length_ : Real(1); }
    /// Sum over the unknowns of (weight z)^2, and the largest of the triples.
    Real squares(const Real* z) const;
    template <class Entry>
    Real largest(Entry z) const;

    const System& system_;
    int n_, triples_, triples_per_body_;
    Real tolerance_, inverse_length_;
    std::vector<Real> inverse_, difference_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
