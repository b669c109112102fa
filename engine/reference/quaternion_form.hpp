// SPDX-License-Identifier: BSD-3-Clause
//
// A model as an ordinary differential equation in R^{13 n}, n bodies, each w = (x, a, v, omega) with a quaternion a:
//   x' = v,   a' = 1/2 a (0, omega),   (v', omega') from the index-1 form.
// R(a) is the rotation of a/|a|, so the right-hand side is defined for every a != 0 and does not depend on |a|; the
// exact flow keeps |a|, and it is not renormalised. The bodies are followed by the angle of each torsion spring with
// theta' as its rate: only its full turns are used.
#pragma once

#include <memory>
#include <vector>

#include "mechanics/system.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// R(a/|a|), body to space; a = (w, x, y, z).
Mat3 rotation_of_quaternion(const Real* a);
/// A quaternion of unit norm with that rotation.
void quaternion_of_rotation(const Mat3& R, Real* a);

/// One object per thread: it owns its work space.
class QuaternionForm {
  public:
    static constexpr int body_size = 13;

    explicit QuaternionForm(const Model& model);

    int dimension() const { return body_size * bodies_ + system_->torsion_springs(); }
    int bodies() const { return bodies_; }
    std::vector<Real> start() const;
    /// Makes the angles behind the bodies those of the poses, which accumulate no error.
    void settle(Real* w);
    Status rate(const Real& t, const Real* w, Real* dw);

    std::vector<BodyState> states(const Real* w) const;
    std::vector<SpringAngle> angles(const Real* w);
    /// Multipliers, in the order and the axes of System.
    Status multipliers(const Real& t, const Real* w, std::vector<Real>& lambda);
    /// |Phi| and |C v + b|.
    struct Residual {
        Real position, velocity;
    };
    Residual residual(const Real& t, const Real* w);
    /// Sizes of the terms of accelerations: norms over all bodies of the sums of sizes of all forces over the mass, and
    /// of all moments times |J^{-1}|. Where these cancel, as in a body held at rest, velocities are round-off of them.
    struct AccelerationScale {
        Real linear = 0, angular = 0;
    };
    AccelerationScale acceleration_scale(const Real& t, const Real* w);
    bool has_redundant_rows() const;
    std::vector<ConstraintRow> rows() const { return system_->constraint_rows(); }

  private:
    void load(const Real* w);
    Motion motion(const Real* w, int body) const;

    Model model_;
    std::unique_ptr<System> system_;
    int bodies_;
    std::vector<Real> y_, acceleration_, rows_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
