// SPDX-License-Identifier: BSD-3-Clause
//
// The equations of motion seen from a frame that moves along with a steady motion y(t) = exp(t a) y_0 exp(t b)
// (relative equilibrium [marsden1992]): a is a symmetry of space, b are spins of bodies about their axes of
// symmetry. y_0 is at rest there.
#pragma once

#include <memory>
#include <vector>

#include "engine/linearised/symmetries.hpp"
#include "mechanics/formulation.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// A state of a model with the fields F, of the equations of motion, and G_c, of a generator c, both as elements of the
/// algebra of TG, z = (q^{-1} q', v'). Everything is in units of the mechanism: 1 rad, its extent, and these times the
/// rate of the motion (1/s) for velocities. The model outlives this.
class SteadyMotion {
  public:
    /// y_0 is the start of `begun`, the same model with its bodies elsewhere.
    SteadyMotion(const Model& model, const std::string& formulation, const Model& begun);

    int size() const { return 2 * n_; }  ///< of z
    /// Where nothing moves by itself, but for the round-off of forces that joints hold, that which these forces would
    /// cause.
    const Real& rate() const { return rate_; }
    /// The state y_0 exp(z).
    std::vector<Real> state(const VecX& z) const;

    /// F and G_c at a state. Throws std::domain_error where F has no value.
    VecX field(const std::vector<Real>& y);
    VecX generated(const std::vector<Real>& y, const Generator& c) const;
    /// Phi and C v + b, divided by their scales, at a state.
    VecX residuals(const std::vector<Real>& y) const;
    /// Whether entry i of z is a rotation of a point mass, which has no meaning.
    bool is_idle(int i) const;

  private:
    VecX in_units(const VecX& z) const { return z.cwiseQuotient(units_); }
    Real rate_of(const std::vector<Real>& y);
    Real rate_of_forces(const std::vector<Real>& y, const Model& begun) const;
    void set_units(const Real& rate);

    const Model& model_;
    std::unique_ptr<System> system_;
    int n_, triples_per_body_;
    Real length_, rate_ = 1;
    VecX units_, row_units_;
    std::vector<Real> start_;
};

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
