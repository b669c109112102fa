// SPDX-License-Identifier: BSD-3-Clause
//
// Baselines: the classical Runge-Kutta method of Boost.Odeint [ahnert2011] on global coordinates of the rotation, which
// is what one does without groups. A step reads the coordinates off R, integrates them as a plain vector, and writes R.
#pragma once

#include "methods/contract/integrator.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Coordinates of one rotation. R may lie off SO(3) where the coordinates do: it is the state that is kept.
class RotationCoordinates {
  public:
    virtual ~RotationCoordinates() = default;
    virtual int size() const = 0;
    virtual void from_matrix(const Real* R, Real* z) const = 0;
    virtual void to_matrix(const Real* z, Real* R) const = 0;
    /// z' for R' = R hat(omega). False at a singularity of the coordinates, or so near that a step h could reach it.
    virtual bool derivative(const Real* z, const Real* omega, const Real& h, Real* dz) const = 0;
    /// Applied to the coordinates after each step.
    virtual void finish(Real* /*z*/) const {}
};

/// Runs for SO3 and SO3xR3, where a body is (x,) R and its velocity (x',) omega.
Factory global_rk4(const std::function<std::shared_ptr<const RotationCoordinates>(const OptionValues&)>& coordinates,
                   std::vector<OptionDescription> options = {});

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
