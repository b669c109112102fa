// SPDX-License-Identifier: BSD-3-Clause
//
// Motion near an equilibrium or a steady motion, linearised on the constraint manifold.
#pragma once

#include <string>

#include "engine/engine.hpp"
#include "mechanics/model/model.hpp"

namespace kreisel {
inline namespace KREISEL_PRECISION {

/// The start y_0 of a model in a formulation that applies. With the generator c of a steady motion through it, the
/// smallest motion of space that spins of bodies leave over, A is the derivative of F - G_c at y_0 on the tangent space
/// of {Phi = 0, C v + b = 0} in TG: where F - G_c = 0 it depends on no chart. The directions of the symmetries' orbit
/// are invariant under A, which acts on them as the bracket with c; what is reported apart are its eigenvalues there,
/// zero where symmetry and steady motion commute, and the others are those on the quotient.
/// `refusal` says why there is no linearisation: F - G_c is above 1e-9 of the rate of the motion for every c, the
/// equations depend on time, or have no value at the start.
Linearisation linearised(const Model& model, const std::string& formulation);
/// The same at the start of `begun`, the model with its bodies elsewhere (engine/begin.hpp).
Linearisation linearised(const Model& model, const std::string& formulation, const Model& begun);

}  // namespace KREISEL_PRECISION
}  // namespace kreisel
