// SPDX-License-Identifier: BSD-3-Clause
//
// Stability on a test rotation: small rotations of a body about a fixed axis under a torque -J Omega^2 theta, which is
// the test equation y' = i Omega y of linear stability [hairer1996, Sec. IV.2] as a method on groups sees it.
#pragma once

#include <vector>

#include "engine/engine.hpp"
#include "mechanics/model/model.hpp"
#include "methods/contract/method.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

class System;
class Integrator;

/// Steps of a method by h of the test rotation as SO3, Omega = 1/s, in z = (theta, theta'/Omega).
class TestRotation {
  public:
    /// Throws std::domain_error if the method does not take it, with the reason.
    TestRotation(const Method& method, const OptionValues& options);
    ~TestRotation();

    /// The largest |mu| of the eigenvalues of one step; of a method with memory, of the recurrence that its steps obey:
    /// z_n ... z_{n-4} as a linear function of those a step before, by least squares over two motions, once the method
    /// has started. NaN if a step fails.
    Real amplification(const Real& h);
    /// What `amplification` may exceed 1 by without growth: round-off.
    Real round_off() const;

  private:
    MatX motion(const Real& theta, const Real& rate, const Real& h, int steps);  ///< z_0, z_1, ..., columns
    MatX step_matrix(const Real& h);
    MatX recurrence_matrix(const Real& h);

    Model model_;
    std::unique_ptr<System> system_;
    std::unique_ptr<Integrator> integrator_;
    bool has_memory_;
};

/// The largest h Omega up to which nothing grows, found on a grid of 1/16 up to 8 and by factors of 5/4 from there to
/// 100, and by bisection: 0 if something grows at 1/8. What order 10 lets grow there is still above round-off.
RotationStability rotation_stability(const Method& method, const OptionValues& options);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
