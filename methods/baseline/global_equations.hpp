// SPDX-License-Identifier: BSD-3-Clause
//
// The equations of motion of all bodies in global coordinates of their rotations, which is what one integrates without
// groups: w' = f(t, w) with w = (x_1, z_1, ..., x_N, z_N, v), z_i coordinates of R_i.
#pragma once

#include <memory>
#include <vector>

#include "methods/baseline/global_coordinates.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// Of SO3 and SO3xR3, where a body is (x,) R and its velocity (x',) omega. Sizes its work space; allocates nothing
/// more.
class GlobalEquations {
  public:
    /// The system outlives this.
    GlobalEquations(System& system, std::shared_ptr<const RotationCoordinates> coordinates);

    std::size_t size() const { return size_; }                           ///< reals of w
    int bodies() const { return bodies_; }                               ///< N
    int translations() const { return translations_; }                   ///< of each body: 3 or 0
    int stride() const { return translations_ + coordinates_->size(); }  ///< reals of (x_i, z_i)

    /// y in TG -> w. The labels of torsion springs, which are not part of a pose, are remembered.
    void read(const Real* y, Real* w);
    /// Those labels, into y.
    void write_labels(Real* y) const;
    /// w -> y in TG; its labels stay as they are.
    void write(const Real* w, Real* y) const;
    /// w' = (x', z', v'). chart_singularity where the coordinates have one within a step h.
    Status derivative(const Real& t, const Real* w, const Real& h, Real* dw);
    /// The same for a slope z = (v, v') of TG; false at a singularity.
    bool rates(const Real* w, const Real* z, const Real& h, Real* dw) const;
    /// Applied to w after each step.
    void finish(Real* w) const;

  private:
    System& system_;
    std::shared_ptr<const RotationCoordinates> coordinates_;
    int bodies_, translations_;
    std::size_t size_;
    std::vector<Real> y_, z_;  // state and slope of the last evaluation
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
